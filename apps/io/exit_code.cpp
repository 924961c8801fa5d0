#include "io/exit_code.h"

#include <cstdio>
#include <new>

#include "io/failure.h"
#include "rbpa/core/error.h"

namespace rbpa::app {

int report(const std::string& program, const std::string& message, ExitCode code) {
  std::fprintf(stderr, "%s: %s\n", program.c_str(), message.c_str());
  return code;
}

int run(const std::string& program, const std::function<void()>& work) {
  try {
    work();
    return done;
  } catch (const WrongUsage& e) {
    return report(program, e.what(), wrong_usage);
  } catch (const BadInput& e) {
    return report(program, e.what(), bad_input_given);
  } catch (const InvalidInput& e) {
    return report(program, e.what(), bad_input_given);
  } catch (const Cancelled&) {
    return report(program, "cancelled", cancelled);
  } catch (const std::bad_alloc&) {
    return report(program, "out of memory", failed);
  } catch (const std::exception& e) {
    return report(program, e.what(), failed);
  }
}

}  // namespace rbpa::app
