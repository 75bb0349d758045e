"""Refuses, in simulation code, what does not give the same bits everywhere.

Library functions whose result the standard leaves open (sin, exp, fminf on zeros), float atomics, fast
intrinsics, and every source of values that are not in the replay.
"""
import re

import gate_tools

# gpu/math/exact_math.h has our own; min, max are ternaries.
LIBRARY = ("sin cos tan asin acos atan atan2 sincos sinh cosh tanh exp exp2 exp10 expm1 log log2 log10 log1p "
           "pow hypot cbrt fma fmin fmax fmod remainder erf tgamma lgamma rsqrt rcbrt sinpi cospi "
           "lrint llrint").split()
REFUSED = [
    # sinf(, std::sin(, ::sinf(; and sin( on its own, but not x.sin( or exact::sin(.
    (re.compile(r"(?<![\w.>:])(?:(?:std)?::)?(?:" + "|".join(LIBRARY) + r")f?\s*\("), "library function"),
    (re.compile(r"\b__(?:sinf|cosf|tanf|expf|exp10f|logf|log2f|log10f|powf|sincosf|saturatef|fdividef|fmaf_r[nzud]"
                r"|f(?:mul|add|div|sub|sqrt|rcp|rsqrt)_r[zud]|frsqrt_rn)\s*\("), "device intrinsic"),
    (re.compile(r"\batomic(?:Add|Sub|Exch|Min|Max|CAS)\s*(?:<\s*(?:float|double)\s*>"
                r"|\(\s*\(?\s*(?:reinterpret_cast|static_cast)?\s*[<(]\s*(?:float|double)\s*\*)"), "float atomic"),
    (re.compile(r"\batomic(?:_ref)?\s*<\s*(?:float|double)\b"), "float atomic"),
    (re.compile(r"#\s*pragma\s+(?:STDC\s+FP_CONTRACT\s+ON|GCC\s+optimize)|-ffast-math|\bfast-math\b"), "float mode"),
    (re.compile(r"\b(?:random_device|mt19937(?:_64)?|system_clock|gettimeofday|clock64)\b"
                r"|(?<![\w.>:])(?:std::)?s?rand\s*\(|\bstd::(?:time|clock)\s*\("
                r"|\b(?:time\s*\(\s*(?:0|NULL|nullptr)\s*|clock\s*\(\s*)\)"), "value that is not in the replay"),
    (re.compile(r"\blong\s+double\b"), "x87 arithmetic"),
]


def check(source, _build):
    offences = []
    names = gate_tools.source_files(source, gate_tools.SIMULATION_FOLDERS)
    for name in names:
        text = gate_tools.without_comments_and_strings((source / name).read_text())
        for number, line in enumerate(text.split("\n"), 1):
            for pattern, why in REFUSED:
                offences += [f"{name}:{number}: {why}: {match.group().strip()}" for match in pattern.finditer(line)]
    print(f"{len(names)} files looked at")
    if not names:
        offences.append("no simulation source was found")
    return offences


def planted(build, folder):
    refused = ["y = sinf(x);", "y = std::sin(x);", "y = ::cosf (x);", "y = sin(x);", "y = fminf(a, b);",
               "y = std::fmax(a, b);", "y = rsqrtf(x);", "y = powf(x, 2.0f);", "y = __expf(x);", "y = std::fma(a, b, c);",
               "y = __fmaf_rn(a, b, c);", "atomicAdd((float*)p, 1.0f);", "atomicAdd<float>(p, 1.0f);",
               "atomicAdd(reinterpret_cast<float*>(p), 1.0f);", "std::atomic<float> sum;", "y = std::rand();",
               "std::random_device device;", "y = time(nullptr);", "y = clock();", "long double y;", "y = atan2f(a, b);",
               "/* why */ y = expf(x);"]
    allowed = ["y = sqrtf(x);", "y = exactSin(x);", "// sinf(x) differs", "y = exact::sin(x);", 'log("sinf(x)");'[4:],
               "y = a < b ? a : b;", "atomicAdd(counts, 1u);", "y = self.cos(x);", "uint32_t n = 1'000'000;",
               "float cosine = runtime(x);", "void time(const char* stage);", "/* sinf(x)\n   cosf(x) */"]
    sources = folder / "game" / "sim"
    sources.mkdir(parents=True)
    (sources / "planted.cu").write_text("\n".join(refused) + "\n")
    offences = check(folder, build)
    lines = {int(offence.split(":")[1]) for offence in offences}
    escaped = [f"not caught: {text}" for number, text in enumerate(refused, 1) if number not in lines]
    (sources / "planted.cu").write_text("\n".join(allowed) + "\n")
    return escaped + [f"refused for nothing: {offence}" for offence in check(folder, build)]


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
