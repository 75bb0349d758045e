# Packages of this build: their documents, their kernels, and what cpack makes.
function(gw_package_test name script) # arguments...
  add_test(NAME ${name} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/${script} ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS e2e SKIP_RETURN_CODE 77 TIMEOUT 600 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
endfunction()

gw_package_test(manual_e2e manual_e2e.py $<TARGET_FILE:gpuwars> ${PROJECT_BINARY_DIR}/documents)
gw_package_test(manual_lint manual_e2e.py $<TARGET_FILE:gpuwars> ${PROJECT_BINARY_DIR}/documents --lint)

set(golden ${PROJECT_SOURCE_DIR}/replays)
gw_package_test(kernel_variants_e2e kernel_variants_e2e.py $<TARGET_FILE:gpuwars_packaged> $<TARGET_FILE:gpuwars>
  ${golden}/hexagon_alone.gwr ${golden}/together_texels.gwr ${golden}/adaptive_odd_even.gwr)
file(GLOB all_golden CONFIGURE_DEPENDS ${golden}/*.gwr)
gw_package_test(kernel_variants_golden kernel_variants_e2e.py $<TARGET_FILE:gpuwars_packaged> $<TARGET_FILE:gpuwars> ${all_golden})
set_tests_properties(kernel_variants_golden PROPERTIES LABELS "golden;slow" TIMEOUT 7200)

set(debs ${CMAKE_CURRENT_BINARY_DIR}/debs)
gw_package_test(deb_contents_e2e deb_contents_e2e.py ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} ${debs})
set_tests_properties(deb_contents_e2e PROPERTIES FIXTURES_SETUP debs)
foreach(tool lintian desktop metainfo)
  gw_package_test(deb_${tool} deb_validators.py ${tool} ${debs})
  set_tests_properties(deb_${tool} PROPERTIES FIXTURES_REQUIRED debs)
endforeach()

# Builds of their own, of the preset package: minutes each. The second needs root and a mirror of Debian 13.
gw_package_test(deb_reproducible deb_reproducible.py ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/reproducible)
gw_package_test(deb_installed deb_installed.py ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/installed)
set_tests_properties(deb_reproducible deb_installed PROPERTIES LABELS "e2e;slow" TIMEOUT 7200 RUN_SERIAL ON)
