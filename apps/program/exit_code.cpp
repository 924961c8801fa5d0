#include "program/exit_code.h"

#include <new>

#include "io/bytes/output_file.h"
#include "io/failure.h"
#include "rbpa/base/error.h"

namespace rbpa::app {

int report(const std::string& program, const std::string& message, ExitCode code) {
  say(program, message);
  return code;
}

void print(const std::string& text) {
  OutputFile out("-");
  out.write(text);
  out.finish();
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
  } catch (const ClosedPipe&) {
    return closed_pipe;
  } catch (const std::bad_alloc&) {
    return report(program, "out of memory", failed);
  } catch (const std::exception& e) {
    return report(program, e.what(), failed);
  }
}

}  // namespace rbpa::app
