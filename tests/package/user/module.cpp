// The same as a module of CPython: user_module.count_pairs(bytes of float32 x, y, ..., radius).
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "shared.h"

static PyObject* countPairs(PyObject*, PyObject* arguments) {
  Py_buffer xy;
  double radius = 0.0;
  if (!PyArg_ParseTuple(arguments, "y*d", &xy, &radius)) return nullptr;
  const auto count = static_cast<uint32_t>(static_cast<size_t>(xy.len) / (2 * sizeof(float)));
  const uint64_t pairs = count_pairs(static_cast<const float*>(xy.buf), count, static_cast<float>(radius));
  PyBuffer_Release(&xy);
  return PyLong_FromUnsignedLongLong(pairs);
}

static PyMethodDef methods[] = {{"count_pairs", countPairs, METH_VARARGS, "Neighbours of all points together."},
                                {nullptr, nullptr, 0, nullptr}};
static PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "user_module", nullptr, -1, methods, nullptr, nullptr, nullptr, nullptr};

PyMODINIT_FUNC PyInit_user_module() {
  return PyModule_Create(&definition);
}
