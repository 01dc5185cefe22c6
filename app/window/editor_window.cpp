// app/window/editor_window.cpp: the loop of the editor, and one frame in order.
#include "app/window/editor_window.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include <epoxy/gl.h>
#include <imgui.h>

#include "app/document/folder_listing.h"
#include "app/document/view_files.h"
#include "app/editor/bindings.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/open_file.h"
#include "app/editor/reference_commands.h"
#include "app/editor/session.h"
#include "app/ui/code_points.h"
#include "app/ui/imgui_layer.h"
#include "app/ui/window.h"
#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/thumbnails.h"
#include "app/viewport/render/viewport.h"
#include "app/window/editor_step.h"
#include "app/window/picture.h"
#include "app/window/session_keeper.h"
#include "app/window/state_log.h"
#include "app/window/surface_on_card.h"

namespace sinew::app {

namespace {

template <class Named>
void addNameLetters(std::u32string& letters, const std::vector<Named>& all) {
  for (const Named& each : all) letters += codePoints(each.name);
}

}  // namespace

std::u32string lettersOfNames(const EditorState& state) {
  std::u32string letters = codePoints(state.document.name());
  if (state.hasCharacter()) {
    const Character& character = state.character();
    addNameLetters(letters, character.skeleton.bones);
    addNameLetters(letters, character.clips);
    addNameLetters(letters, character.morphTargets);
    addNameLetters(letters, character.parts);
    addNameLetters(letters, state.document.rig().primitives);
    addNameLetters(letters, state.document.rig().sheets);
    addNameLetters(letters, state.document.rig().groups);
    for (const LayerChoice& choice : state.document.rig().layers) letters += codePoints(choice.part);
  }
  std::erase_if(letters, [](char32_t c) { return c < 0x80; });
  return letters;
}

std::string missingLetters(const std::u32string& letters, const HasGlyph& hasGlyph) {
  const auto missing = [&](char32_t c) { return !isInvisible(c) && !hasGlyph(c); };
  const auto wide = [&](char32_t c) { return isWide(c) && missing(c); };
  if (std::ranges::none_of(letters, missing)) return "";
  std::string text = "Some names are shown by number: no installed font has their letters.";
  if (std::ranges::any_of(letters, wide)) text += " Debian's package fonts-noto-cjk has Chinese, Japanese and Korean.";
  return text;
}

namespace {

constexpr glm::ivec2 kWindowSize{1280, 800};
constexpr const char* kTitle = "Sinew";
constexpr double kIdleSeconds = 1.0;    ///< Longest sleep.
constexpr double kCaretSeconds = 0.25;  ///< ... while a caret blinks.
constexpr double kLookSeconds = 0.5;    ///< Between queries of the window's place.
constexpr int kSettleFrames = 3;        ///< Drawn after input: ImGui shows hovers and closed popups late.

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Editor {
 public:
  Editor(Window& window, Viewport& viewport, EditorState state, SessionKeeper keeper, const EditorOptions& options,
         std::optional<StateLog> log)
      : window_(window),
        imgui_(window.handle(), scaleOf(window, state, options)),
        thumbnails_(thumbnailFolder()),
        picture_(viewport, thumbnails_),
        options_(options),
        log_(std::move(log)),
        state_(std::move(state)),
        keeper_(std::move(keeper)) {
    state_.session.thumbnails = &thumbnails_;
  }

  /// Opens the document, else a sample. Error: it cannot be smoothed. @param orphan  a rig that lacks its character
  Result<void> open(std::optional<Document> document, const std::filesystem::path& orphan) {
    if (document) {
      if (!showDocument(state_, std::move(*document))) return Error{"", "", state_.session.messages.back().text};
    } else if (const std::filesystem::path sample = firstSample(); !sample.empty()) {
      openFile(state_, sample);
    }
    if (!orphan.empty()) openFile(state_, orphan);
    return {};
  }

  void run() {
    while (!state_.session.quit) {
      if (waitForWork()) frame();
      refinePicture();
      if (const double now = secondsNow(); now - lastLook_ >= kLookSeconds) {
        lastLook_ = now;
        place_ = window_.place();
      }
      const std::size_t said = state_.session.messagesSaid;
      keeper_.tick(state_, secondsNow(), place_);
      if (state_.session.messagesSaid != said) settle_ = kSettleFrames;
    }
    picture_.keepThumbnail();
    keeper_.finish(state_, window_.place());
  }

 private:
  /// From the command line, else the preferences, else the system.
  static float scaleOf(const Window& window, const EditorState& state, const EditorOptions& options) {
    if (options.scale > 0.0f) return options.scale;
    return state.session.preferences.scale > 0.0f ? state.session.preferences.scale : window.contentScale();
  }

  /// Longest sleep while nothing moves.
  double idleSeconds(bool caret) const {
    double seconds = caret ? kCaretSeconds : kIdleSeconds;
    if (step_.wakeAfter() > 0.0) seconds = std::min(seconds, step_.wakeAfter());
    if (const auto left = keeper_.secondsLeft(state_, secondsNow())) seconds = std::clamp(*left, 1e-3, seconds);
    if (const auto left = picture_.secondsUntilRefining(state_, secondsNow())) seconds = std::min(*left, seconds);
    return seconds;
  }

  /// Takes events, sleeping if nothing moves. @return whether a frame is due
  bool waitForWork() {
    const bool moving = (state_.open.transport.playing && state_.hasCharacter()) || state_.frame.route.needsFrame ||
                        window_.input().pending() || settle_ > 0;
    const double wake = step_.wakeAfter();
    continuous_ = moving;
    if (!moving) show();
    const bool caret = ImGui::GetIO().WantTextInput;
    if (moving) {
      window_.poll();
    } else if (const double seconds = idleSeconds(caret); seconds > 0.0) {
      window_.wait(seconds);
    } else {
      window_.poll();
    }
    state_.frame.now = secondsNow();  // For messages about dropped files.
    for (const std::filesystem::path& file : window_.takeDrops()) {
      if (state_.hasCharacter() && isReferenceName(file.filename().string())) dropReference(state_, file);
      else dropFile(state_, file);
      settle_ = kSettleFrames;
    }
    if (window_.closeRequested()) {
      window_.clearCloseRequest();
      request(state_, {IntentKind::kQuit, {}});
      settle_ = kSettleFrames;
    }
    if (window_.takeRefresh()) settle_ = exposed_ = kSettleFrames;
    const bool due = moving || caret || wake > 0.0 || window_.input().pending() || settle_ > 0;
    if (window_.input().pending()) settle_ = kSettleFrames;
    return due && !state_.session.quit;
  }

  void savePicture(const std::filesystem::path& file) {
    if (!state_.hasCharacter()) return;
    const Result<void> saved = picture_.save(state_, file);
    if (saved) say(state_, "Picture saved as " + file.string());
    else addMessage(state_.session, MessageKind::kError, "The picture was not saved: " + saved.error().text());
    settle_ = kSettleFrames;
  }

  /// Adds one sample at a time, so that input need not wait.
  void refinePicture() {
    if (const auto wanted = std::exchange(state_.session.pictureWanted, std::nullopt)) savePicture(*wanted);
    if (continuous_ || settle_ > 0 || window_.input().pending() || state_.session.quit) return;
    const std::optional<double> left = picture_.secondsUntilRefining(state_, secondsNow());
    if (left && *left <= 0.0 && picture_.refine(state_)) settle_ = 1;
  }

  void frame() {
    const double start = secondsNow();
    const double since = lastFrame_ > 0.0 ? start - lastFrame_ : 1.0 / 60.0;
    // After a sleep, movements do not advance by the time slept.
    const double delta = continuous_ ? since : 1.0 / 60.0;
    lastFrame_ = start;
    if (settle_ > 0) --settle_;
    const RawInput& input = window_.input().next();
    state_.frame.now = start;
    state_.frame.systemScale = window_.contentScale();
    state_.frame.uiScale = scaleOf(window_, state_, options_);
    readNames();
    if (imgui_.prepareFonts(state_.frame.uiScale)) screen_.forget();
    imgui_.beginFrame(input, since, state_.session.stats.now() * 1e-3);
    step_.run(state_, input, imgui_.fonts(), delta);
    if (step_.cameraMoves()) settle_ = std::max(settle_, 2);  // The hover follows a frame later.
    const View& view = state_.frame.route.view;
    onCard_.follow(state_);
    const double drawing = secondsNow();
    show();
    picture_.draw(state_, onCard_.drawn(), view, *ImGui::GetBackgroundDrawList(), drawing, resolution(input));
    present();
    const double end = secondsNow();
    if (moving_ > 1 && picture_.isNew() && adapts()) {
      resolution_.add({end - drawing, drawing - start, overlaps() ? drawing - start : 0.0});
    }
    state_.session.stats.add(end, (continuous_ && delta > 0.0 ? delta : end - start) * 1e3);
    if (log_) log_->write(state_, step_.widgets(), view, frameNumber_, end - startTime_);
    ++frameNumber_;
  }

  /// After opening a document: requests its letters, and reports those that no font has.
  void readNames() {
    if (namesOf_ == state_.session.documentsOpened) return;
    namesOf_ = state_.session.documentsOpened;
    const std::u32string letters = lettersOfNames(state_);
    imgui_.wantLetters(letters, hanRegion(letters, localeOfEnvironment()));
    const std::string missing = missingLetters(letters, [this](char32_t c) { return imgui_.hasLetter(c); });
    if (!missing.empty()) addMessage(state_.session, MessageKind::kNote, missing);
  }

  /// On a graphics card the time to draw includes the wait for the monitor, and says nothing.
  bool adapts() const { return isSoftwareRenderer() && !state_.session.preferences.fullWhileMoving; }

  /// Scale of this frame's picture. The first frame of a movement is full size: it may be the only one.
  std::optional<float> resolution(const RawInput& input) {
    const bool moves = state_.open.transport.playing || step_.cameraMoves() || state_.frame.route.needsFrame ||
                       std::ranges::find(input.buttons, true) != input.buttons.end();
    moving_ = moves ? moving_ + 1 : 0;
    if (moving_ < 2) return std::nullopt;
    return adapts() ? resolution_.scale() : 1.0f;
  }

  void present() {
    ImDrawData& data = imgui_.endFrame();
    if (imgui_.lettersMissing()) settle_ = std::max(settle_, 1);
    const auto fonts = reinterpret_cast<std::uintptr_t>(ImGui::GetIO().Fonts->TexID);
    const std::array textures{TextureRevision{fonts}, picture_.revision()};
    const bool still = exposed_ == 0 && !state_.open.transport.playing && !state_.frame.route.needsFrame;
    if (exposed_ > 0) --exposed_;
    const glm::vec4& v = state_.frame.viewport;
    const glm::vec4 covered = state_.hasCharacter() ? glm::vec4(v.x, v.y, v.x + v.z, v.y + v.w) : glm::vec4(0.0f);
    const bool shows = screen_.draw(data, window_.framebufferSize(), textures, picture_.changed(), covered, still);
    const std::string name = state_.document.name() + (state_.document.commands.modified() ? "*" : "");
    window_.setTitle(state_.hasCharacter() ? name + " - " + kTitle : kTitle);
    if (!shows) return;
    unshown_ = true;
    if (overlaps()) glFlush();
    else show();
  }

  void show() {
    if (!std::exchange(unshown_, false)) return;
    window_.swap();
    screen_.noteShown();
  }

  /// Shows a frame while the next one's surface is computed: where the processor draws, its other cores are free until
  /// the swap, which waits for all pixels.
  bool overlaps() const { return isSoftwareRenderer() && moving_ > 1; }

  Window& window_;
  ImGuiLayer imgui_;
  Thumbnails thumbnails_;
  Picture picture_;
  EditorOptions options_;
  std::optional<StateLog> log_;
  EditorState state_;
  SessionKeeper keeper_;
  EditorStep step_;
  SurfaceOnCard onCard_;
  Screen screen_;
  MovingResolution resolution_;
  int moving_ = 0;  ///< Frames in a row.
  double startTime_ = secondsNow();
  double lastFrame_ = 0.0;
  double lastLook_ = -kLookSeconds;
  WindowPlace place_;
  long long frameNumber_ = 0;
  std::size_t namesOf_ = static_cast<std::size_t>(-1);  ///< documentsOpened when names were read.
  int settle_ = kSettleFrames;
  bool unshown_ = false;         ///< A frame is drawn but not shown.
  int exposed_ = kSettleFrames;  ///< Frames to show even if unchanged.
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
  // Before the window opens, so that a bad file is reported without a display.
  std::optional<Document> document;
  std::optional<Error> orphaned;  ///< A rig without its character: the window asks for it.
  if (!options.file.empty()) {
    Result<Document> opened = openDocument(options.file);
    if (opened) document = std::move(opened).value();
    else if (missingCharacter(options.file)) orphaned = opened.error();
    else return refuse(opened.error());
  }
  EditorState state;
  SessionKeeper keeper(preferencesFile(), recoveryFolder(), viewsFolder());
  keeper.start(state);
  for (const std::string& note : dropUnusableKeys(state.session.preferences)) {
    addMessage(state.session, MessageKind::kNote, "preferences: " + note + "; ignored", MessageAbout::kProgram);
  }
  const float grown = options.scale > 0.0f ? options.scale : std::max(state.session.preferences.scale, 1.0f);
  const glm::ivec2 size(glm::vec2(kWindowSize) * grown);
  WindowPlace place = state.session.preferences.window;
  // The window of a smaller interface may be too small.
  const bool larger = options.scale > std::max(state.session.preferences.scale, 1.0f);
  if (larger && (place.width < size.x || place.height < size.y)) place = {};
  const Result<std::unique_ptr<Window>> window = Window::open(size, kTitle, place);
  if (!window) return refuse(orphaned.value_or(window.error()));
  const Result<std::unique_ptr<Viewport>> viewport = Viewport::create(Viewport::defaultSamples());
  if (!viewport) return refuse(viewport.error());
  Editor editor(*window.value(), *viewport.value(), std::move(state), std::move(keeper), options, std::move(log));
  if (const Result<void> opened = editor.open(std::move(document), orphaned ? options.file : ""); !opened)
    return refuse(opened.error());
  editor.run();
  return 0;
}

}  // namespace sinew::app
