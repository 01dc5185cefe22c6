// app/editor/line_commands.cpp: lengths, via points and ends of lines.

#include "app/editor/line_commands.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "core/bodies/mend.h"
#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/line_rest.h"
#include "core/rig/twins.h"

namespace sinew::app {
namespace {

/// Applies `step` where possible. @return the rig and the number of changed lines. Error: the first refusal if none.
template <class Step>
Result<std::pair<Rig, std::size_t>> forEachLine(Rig rig, const std::vector<int>& lines, Step step) {
  std::size_t done = 0;
  std::optional<Error> refusal;
  for (const int line : lines) {
    Result<Rig> next = step(rig, line);
    if (!next) {
      if (!refusal) refusal = next.error();
      continue;
    }
    rig = std::move(next).value();
    ++done;
  }
  if (done == 0 && refusal) return *refusal;
  return std::pair(std::move(rig), done);
}

/// @param what  "Rest length of"
template <class Step>
void editEachLine(EditorState& state, const std::vector<int>& lines, const char* what, Step step) {
  if (lines.empty()) return;
  auto changed = forEachLine(state.document.rig(), lines, step);
  const std::string label = std::string(what) + " " + namedLines(state.document.rig(), lines);
  if (!changed) return refuse(state, changed.error());
  const std::size_t done = changed->second;
  if (!edit(state, label, std::move(changed->first)) || done == lines.size()) return;
  say(state, label + ": done for " + std::to_string(done) + ", the others cannot in this pose");
}

const PosedLine& posed(const EditorState& state, int line) {
  return at(state.document.posedRig(state.live->pose()).lines, line);
}

Error noBones() { return errorAt({}, "bones of this line are missing here"); }

std::vector<int> withVia(const EditorState& state, bool there) {
  std::vector<int> lines = selectedLines(state.document).indices;
  std::erase_if(lines, [&](int line) { return at(state.document.rig().lines, line).via.has_value() != there; });
  return lines;
}

void warnOf(EditorState& state, const std::string& warning, const MuscleLine& line) {
  addMessage(state.session, MessageKind::kWarning, warning);
  state.session.messages.back().line = line;
}

}  // namespace

SelectedLines selectedLines(const Document& document) {
  SelectedLines lines;
  const Rig& rig = document.rig();
  std::set<int> found;
  for (const int index : withoutSheets(rig, selectedIndices(document))) {
    const int line = findLine(rig, at(rig.primitives, index).line);
    if (line < 0) continue;
    found.insert(line);
    ++lines.muscles;
  }
  lines.indices.assign(found.begin(), found.end());
  const int active = document.activePrimitive();
  if (active >= 0 && !isBelly(rig, active)) lines.active = findLine(rig, at(rig.primitives, active).line);
  if (lines.active < 0 && !lines.indices.empty()) lines.active = lines.indices.front();
  return lines;
}

std::vector<int> flexingLines(const Document& document) {
  std::set<int> lines;
  for (const int index : selectedIndices(document)) {
    lines.insert(findLine(document.rig(), at(document.rig().primitives, index).line));
  }
  lines.erase(-1);
  return {lines.begin(), lines.end()};
}

std::string namedLines(const Rig& rig, const std::vector<int>& lines) {
  return lines.size() == 1 ? at(rig.lines, lines.front()).name : withCount(lines.size(), "line");
}

Result<Rig> editLines(Rig rig, const std::vector<int>& lines, const std::function<void(MuscleLine&)>& change) {
  for (const int line : lines) {
    Result<Rig> next = editLine(std::move(rig), line, change);
    if (!next) return next.error();
    rig = std::move(next).value();
  }
  return rig;
}

void setRestToNow(EditorState& state) {
  const std::vector<int> lines = selectedLines(state.document).indices;
  editEachLine(state, lines, "Rest length of", [&](const Rig& rig, int line) -> Result<Rig> {
    const PosedLine& now = posed(state, line);
    if (!now.usable) return noBones();
    return withRestNow(rig, line, now.stretch);
  });
}

void setFullContractionToNow(EditorState& state) {
  const std::vector<int> lines = selectedLines(state.document).indices;
  editEachLine(state, lines, "Full contraction of", [&](const Rig& rig, int line) -> Result<Rig> {
    const PosedLine& now = posed(state, line);
    if (!now.usable) return noBones();
    return withFullNow(rig, line, now.stretch);
  });
}

void learnContraction(EditorState& state) {
  const std::vector<int> lines = selectedLines(state.document).indices;
  if (lines.empty()) return;
  const Character& character = state.character();
  std::string said;
  std::vector<std::pair<int, std::string>> warnings;
  auto learned = forEachLine(state.document.rig(), lines, [&](const Rig& rig, int line) -> Result<Rig> {
    const Result<LineRest> rest = lineRest(at(rig.lines, line), character);
    if (!rest) return rest.error();
    Result<Learned> own = withLearned(rig, line, lengthsOver(rest.value(), character, character.clips));
    if (!own) return own.error();
    said = own->said;
    if (!own->warning.empty()) warnings.emplace_back(line, own->warning);
    return std::move(own->rig);
  });
  if (!learned) return sayRefusal(state, learned.error().plainText());
  const std::size_t done = learned->second;
  const std::string of = namedLines(state.document.rig(), lines);
  if (!edit(state, "Learn contraction of " + of, std::move(learned->first))) return;
  if (lines.size() > 1) {
    said = "Full contraction learned for ";
    said += done == lines.size() ? of : std::to_string(done) + " of " + of + "; the others never get shorter";
  }
  say(state, said);
  for (const auto& [line, warning] : warnings) warnOf(state, warning, at(state.document.rig().lines, line));
}

void addViaPoints(EditorState& state) {
  editEachLine(state, withVia(state, false), "Add via point to",
               [&](const Rig& rig, int line) { return withViaPoint(rig, line, state.character()); });
}

void removeViaPoints(EditorState& state) {
  editEachLine(state, withVia(state, true), "Remove via point of",
               [](const Rig& rig, int line) { return withoutViaPoint(rig, line); });
}

void takeOffLines(EditorState& state) {
  const Rig& rig = state.document.rig();
  std::vector<int> muscles = withoutSheets(rig, selectedIndices(state.document));
  std::erase_if(muscles, [&](int index) { return at(rig.primitives, index).line.empty(); });
  if (muscles.empty()) return;
  const std::string whose = muscles.size() == 1 ? " off its line" : " off their lines";
  edit(state, "Take " + namedMuscles(rig, muscles) + whose, setLineOfSeveral(rig, muscles, -1));
}

void attachOtherEnd(EditorState& state, int bone) {
  const Document& document = state.document;
  const Skeleton& skeleton = state.character().skeleton;
  std::vector<int> attached;
  std::string said;
  const Motions motions(document.character);
  Rig rig = document.rig();
  for (const int index : withoutSheets(rig, selectedIndices(document))) {
    const Primitive& muscle = at(rig.primitives, index);
    if (!muscle.line.empty() || skeleton.findBone(muscle.bone) == bone) continue;
    Result<Rig> lined = withOtherEnd(std::move(rig), index, bone, state.character());
    if (!lined) return refuse(state, lined.error());
    const auto last = static_cast<int>(lined->lines.size()) - 1;
    Result<Mended> mended = withMendedLine(std::move(lined).value(), last, motions, MadeLine::kOtherEnd);
    if (!mended) return refuse(state, mended.error());
    rig = std::move(mended.value().rig);
    if (!mended->said.empty())
      said += (said.empty() ? "" : "; ") + at(rig.primitives, index).name + ": " + mended->said;
    if (document.mirror) rig = withTwinOnLine(std::move(rig), index, *document.mirror);
    attached.push_back(index);
  }
  if (attached.empty()) return;
  const std::string label = "Attach " + namedMuscles(document.rig(), attached) + " to " + shownBoneName(skeleton, bone);
  if (edit(state, label, std::move(rig)) && !said.empty()) say(state, said);
}

void forgetSettledWarnings(EditorState& state) {
  const Rig& rig = state.document.rig();
  std::erase_if(state.session.messages, [&](const Message& message) {
    if (!message.line) return false;
    const int index = findLine(rig, message.line->id());
    if (index < 0) return true;
    const MuscleLine& now = at(rig.lines, index);
    return now.via != message.line->via || now.origin != message.line->origin ||
           now.insertion != message.line->insertion;
  });
}

}  // namespace sinew::app
