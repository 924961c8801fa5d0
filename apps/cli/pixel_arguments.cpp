#include "cli/pixel_arguments.h"

#include "io/bytes/number.h"
#include "io/failure.h"

namespace rbpa::app {

PixelRule parse_pixel_rule(const PixelArguments& arguments) {
  PixelRule rule;
  if (arguments.foreground) {
    if (*arguments.foreground != "dark" && *arguments.foreground != "light")
      throw WrongUsage("--foreground: found " + in_quotes(*arguments.foreground) + ", expected dark or light");
    rule.foreground = *arguments.foreground == "dark" ? Foreground::dark : Foreground::light;
  }
  if (arguments.threshold) {
    const ParsedNumber number = parse_whole_number(*arguments.threshold);
    if (number.fault != NumberFault::none || !(number.value > 0 && number.value <= 1))
      throw WrongUsage("--threshold: found " + in_quotes(*arguments.threshold) +
                       ", expected a share of white: a number > 0 and <= 1");
    rule.threshold = number.value;
  }
  return rule;
}

}  // namespace rbpa::app
