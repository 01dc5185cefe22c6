// app/command/parse_refusal.h: why a parser refuses a command line, with what was probably meant.
#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace sinew::app {

/// @param parser  of the verb, after the parse that failed
[[nodiscard]] std::string parseRefusal(const CLI::App& parser, const CLI::ParseError& error);

}  // namespace sinew::app
