// app/editor.cpp: one frame, in order.

#include "app/editor.h"

#include <epoxy/gl.h>

#include <imgui.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/panels/commands.h"
#include "app/panels/panels.h"
#include "app/panels/picture.h"
#include "app/panels/state_log.h"
#include "app/panels/viewport_input.h"
#include "app/platform/data_files.h"
#include "app/platform/imgui_layer.h"
#include "app/platform/window.h"
#include "app/render/viewport.h"

namespace sinew::app {
namespace {

constexpr glm::ivec2 kWindowSize{1280, 800};
constexpr const char* kTitle = "Sinew";
constexpr double kIdleSeconds = 1.0;    ///< Longest sleep when nothing happens.
constexpr double kCaretSeconds = 0.25;  ///< ... while a text field's caret blinks.
constexpr int kSettleFrames = 3;  ///< Drawn after the last input: ImGui shows hovers and closed popups a frame late.

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The running editor.
class Editor {
 public:
  Editor(Window& window, Viewport& viewport, std::optional<StateLog> log)
      : window_(window), imgui_(window.handle(), window.contentScale()), picture_(viewport), log_(std::move(log)) {
    state_.uiScale = imgui_.scale();
  }

  /// The document the command line named, else the bundled character. Error: it cannot be smoothed.
  Result<void> open(std::optional<Document> document) {
    const std::filesystem::path sample = dataFile("assets/demo.rig.json");
    std::error_code ignored;
    if (document) {
      if (!showDocument(state_, std::move(*document))) return Error{"", "", state_.messages.back().text};
    } else if (std::filesystem::is_regular_file(sample, ignored)) {
      openFile(state_, sample);
    }
    return {};
  }

  void run() {
    while (!state_.quit) {
      if (waitForWork()) frame();
    }
  }

 private:
  /// Takes events, sleeping if nothing moves. @return whether a frame is due.
  bool waitForWork() {
    const bool moving = (state_.transport.playing && state_.hasCharacter()) || state_.route.needsFrame ||
                        window_.input().pending() || settle_ > 0;
    const double wake = state_.wakeAfter;
    continuous_ = moving;
    const bool caret = ImGui::GetIO().WantTextInput;
    if (moving) {
      window_.poll();
    } else {
      window_.wait(caret ? kCaretSeconds : (wake > 0.0 ? wake : kIdleSeconds));
    }
    for (const std::filesystem::path& file : window_.takeDrops()) {
      request(state_, {IntentKind::kOpenFile, file});
      settle_ = kSettleFrames;
    }
    if (window_.closeRequested()) {
      window_.clearCloseRequest();
      request(state_, {IntentKind::kQuit, {}});
      settle_ = kSettleFrames;
    }
    if (window_.takeRefresh()) settle_ = kSettleFrames;
    const bool due = moving || caret || wake > 0.0 || window_.input().pending() || settle_ > 0;
    if (window_.input().pending()) settle_ = kSettleFrames;
    return due && !state_.quit;
  }

  void frame() {
    const double start = secondsNow();
    const double since = lastFrame_ > 0.0 ? start - lastFrame_ : 1.0 / 60.0;
    // After a sleep the time since the last frame means nothing to what moves.
    const double delta = continuous_ ? since : 1.0 / 60.0;
    lastFrame_ = start;
    if (settle_ > 0) --settle_;
    const InputFrame& input = window_.input().next();
    imgui_.beginFrame(input, since);
    state_.wakeAfter = 0.0;
    keys(input);
    widgets_.beginFrame();
    Ui ui{state_, widgets_, imgui_.fonts()};
    const bool free = drawLayout(ui);
    movePose(delta);
    tools(input, free, delta);
    updateSurface();
    const View& view = state_.route.view;
    picture_.draw(state_, view, *ImGui::GetBackgroundDrawList());
    present();
    const double end = secondsNow();
    state_.stats.add(end, (continuous_ && delta > 0.0 ? delta : end - start) * 1e3);
    if (log_) log_->write(state_, widgets_, view, frameNumber_, end - startTime_);
    ++frameNumber_;
  }

  void keys(const InputFrame& input) {
    const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (!popup && !isTyping() && !ownsKeyboard(state_.tools)) runShortcut(state_, input);
  }

  /// A text field has the keyboard. ImGui goes on wanting text for a frame after the field is left, and a key that
  /// comes in that frame would be lost.
  static bool isTyping() { return ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive(); }

  void tools(const InputFrame& input, bool free, double delta) {
    if (!state_.hasCharacter()) return;
    if (state_.frameWanted) {
      frameBounds(state_.tools.camera, boundsOf(state_.live->surface().positions), state_.viewportPixels, false);
      state_.frameWanted = false;
    }
    const ImGuiIO& io = ImGui::GetIO();
    const InterfaceClaims claims{free, isTyping(), ImGui::IsMouseDoubleClicked(0)};
    const glm::vec2 pixelsPerUnit{io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y};
    const FrameInput viewportFrame = viewportInput(input, claims, state_.viewport, pixelsPerUnit, delta);
    const ViewportContext context{state_.document, state_.live->pose(),   &state_.live->surface(),
                                  state_.display,  state_.viewportPixels, state_.uiScale * pixelsPerUnit.x};
    state_.route = routeInput(state_.tools, viewportFrame, context);
    if (!state_.route.message.empty()) addMessage(state_, MessageKind::kError, state_.route.message);
  }

  void movePose(double delta) {
    if (!state_.hasCharacter()) return;
    advance(state_.transport, delta, state_.character());
    state_.live->movePose(state_.transport);
  }

  void updateSurface() {
    if (!state_.hasCharacter()) return;
    const Result<bool> updated = state_.live->update(state_.document.commands, surfaceView(state_));
    if (!updated) addMessage(state_, MessageKind::kError, updated.error().text());
    state_.stats.stages = state_.live->surface().report.seconds;
  }

  void present() {
    const glm::ivec2 size = window_.framebufferSize();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
    const Tint back = palette::kBackground;
    glClearColor(back.r, back.g, back.b, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    imgui_.endFrame();
    const std::string name = state_.document.name() + (state_.document.commands.modified() ? "*" : "");
    window_.setTitle(state_.hasCharacter() ? name + " - " + kTitle : kTitle);
    window_.swap();
  }

  Window& window_;
  ImGuiLayer imgui_;
  Picture picture_;
  std::optional<StateLog> log_;
  EditorState state_;
  WidgetLog widgets_;
  double startTime_ = secondsNow();
  double lastFrame_ = 0.0;
  long long frameNumber_ = 0;
  int settle_ = kSettleFrames;
  bool continuous_ = false;
};

int refuse(const Error& error) {
  std::fprintf(stderr, "sinew: %s\n", error.text().c_str());
  return 1;
}

}  // namespace

int runEditor(const EditorOptions& options) {
  std::optional<StateLog> log;
  if (!options.logState.empty()) {
    Result<StateLog> opened = StateLog::open(options.logState);
    if (!opened) return refuse(opened.error());
    log = std::move(opened).value();
  }
  // Before the window: a bad file is told apart from a missing display, and nothing flashes up.
  std::optional<Document> document;
  if (!options.file.empty()) {
    Result<Document> opened = openDocument(options.file);
    if (!opened) return refuse(opened.error());
    document = std::move(opened).value();
  }
  const Result<std::unique_ptr<Window>> window = Window::open(kWindowSize, kTitle);
  if (!window) return refuse(window.error());
  const Result<std::unique_ptr<Viewport>> viewport = Viewport::create(Viewport::defaultSamples());
  if (!viewport) return refuse(viewport.error());
  Editor editor(*window.value(), *viewport.value(), std::move(log));
  if (const Result<void> opened = editor.open(std::move(document)); !opened) return refuse(opened.error());
  editor.run();
  return 0;
}

}  // namespace sinew::app
