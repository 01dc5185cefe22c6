// app/main.cpp: picks verb or window.
#include <csignal>
#include <exception>
#include <new>

#include "app/command/console.h"
#include "app/command/verbs.h"
#include "app/window/editor_window.h"
#include "core/geometry/instruction_set.h"

namespace {

int edit(const sinew::app::EditRequest& request) {
  sinew::app::EditorOptions options;
  options.file = request.file;
  options.logState = request.logState;
  options.scale = request.scale;
  return sinew::app::runEditor(options);
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto able = sinew::checkProcessor(); !able) return sinew::app::badInput(able.error());
  std::signal(SIGXFSZ, SIG_IGN);  // A file that may not grow is an error of the call that writes it.
  try {
    return sinew::app::runCommandLine(argc, argv, edit);
  } catch (const std::bad_alloc&) {
    return sinew::app::badInput(sinew::errorAt({}, "out of memory"));
  } catch (const std::exception& error) {
    return sinew::app::badInput(sinew::errorAt({}, error.what()));
  }
}
