// What: translates errors of reading and writing files into exceptions for Python.
#pragma once

#include <pybind11/pybind11.h>

#include "io/failure.h"
#include "rbpa/base/error.h"

namespace rbpa::python {

/// Returns the result of work(). If work() throws BadInput or WrongUsage, throws InvalidInput with the text of the
/// exception; if it throws Failure, raises OSError.
template <typename Work>
auto with_file_errors(Work work) {
  try {
    return work();
  } catch (const app::BadInput& refusal) {
    throw InvalidInput(app::printable(refusal.what()));
  } catch (const app::WrongUsage& refusal) {
    throw InvalidInput(app::printable(refusal.what()));
  } catch (const app::Failure& failure) {
    PyErr_SetString(PyExc_OSError, app::printable(failure.what()).c_str());
    throw pybind11::error_already_set();
  }
}

}  // namespace rbpa::python
