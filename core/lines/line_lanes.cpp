// core/lines/line_lanes.cpp: lines dealt to lanes.
#include "core/lines/line_lanes.h"

#include <algorithm>

#include "core/base/at.h"

namespace sinew {
namespace {

/// What settings decide.
void settleLane(LineBlock& block, std::size_t lane, const LineRest& rest) {
  const LineSettings& settings = rest.settings;
  const auto set = [lane](LaneDoubles& of, auto value) { of.lane[lane] = static_cast<double>(value); };
  block.start.set(lane, rest.start);
  set(block.depth, rest.depth);
  set(block.restLength, static_cast<double>(settings.rest) * rest.length);
  set(block.tendon, settings.tendons.x);
  set(block.belly, bellyShare(settings));
  set(block.bellyStretch, rest.bellyStretch);
  set(block.exponent, -0.5 * rest.girth.volume);
  set(block.least, rest.girth.least);
  set(block.most, rest.girth.most);
  set(block.inBind, rest.girth.inBind);
  set(block.twist, settings.twist);
  set(block.flexHeight, settings.flex.x);
  set(block.flexWidth, settings.flex.y);
  set(block.base, settings.base);
  set(block.gain, settings.gain);
  set(block.full, settings.full);
  block.viaShift.set(lane, rest.viaShift);
}

}  // namespace

void setLane(LineBlock& block, std::size_t lane, const LineRest& rest) {
  block.hasVia = rest.via.has_value();
  block.origin.set(lane, rest.origin.inBone);
  block.insertion.set(lane, rest.insertion.inBone);
  if (rest.via) block.via.set(lane, rest.via->inBone);
  block.direction.set(lane, rest.direction);
  block.height.set(lane, rest.frame[2]);
  block.length.lane[lane] = rest.length;
  settleLane(block, lane, rest);
}

LineLanes::LineLanes(std::span<const std::optional<LineRest>> rests) : placeOf_(rests.size(), 0) {
  for (const bool hasVia : {false, true}) {
    for (std::size_t i = 0; i < rests.size(); ++i) {
      if (rests[i] && rests[i]->via.has_value() == hasVia) add(static_cast<int>(i), *rests[i]);
    }
  }
  for (std::size_t i = 0; i < rests.size(); ++i) {
    if (!rests[i]) missing_.push_back(static_cast<int>(i));
  }
}

void LineLanes::settle(int line, const LineRest& rest) {
  const std::size_t place = at(placeOf_, line);
  settleLane(blocks_[place / kDoubleLanes], place % kDoubleLanes, rest);
}

void LineLanes::add(int line, const LineRest& rest) {
  const bool hasVia = rest.via.has_value();
  if (blocks_.empty() || blocks_.back().count == kDoubleLanes || blocks_.back().hasVia != hasVia) {
    blocks_.emplace_back();
  }
  LineBlock& block = blocks_.back();
  const std::size_t lane = block.count++;
  setLane(block, lane, rest);
  block.line[lane] = line;
  block.originBone[lane] = placeOfBone(rest.origin.bone);
  block.insertionBone[lane] = placeOfBone(rest.insertion.bone);
  if (rest.via) block.viaBone[lane] = placeOfBone(rest.via->bone);
  at(placeOf_, line) = (blocks_.size() - 1) * kDoubleLanes + lane;
}

int LineLanes::placeOfBone(int bone) {
  const auto found = std::ranges::find(bones_, bone);
  const auto place = static_cast<int>(found - bones_.begin());
  if (found == bones_.end()) bones_.push_back(bone);
  return place;
}

}  // namespace sinew
