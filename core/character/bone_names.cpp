// core/character/bone_names.cpp: finds side markers and words in names; lists the words for each body part.
#include "core/character/bone_names.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "core/geometry/nearest_name.h"

namespace sinew {

namespace {

struct MarkerPair {
  std::string_view left;
  std::string_view right;
};

constexpr MarkerPair kWords{"left", "right"};
constexpr std::array<MarkerPair, 4> kShort{MarkerPair{"l", "r"}, MarkerPair{"lf", "rt"}, MarkerPair{"fl", "fr"},
                                           MarkerPair{"bl", "br"}};

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isLower(char c) { return c >= 'a' && c <= 'z'; }
bool isLetter(char c) { return isUpper(c) || isLower(c); }

/// A word begins at `at`: after anything but a letter, at a capital after a small letter, or at the last capital of a
/// run before a small letter ("LArm": L, Arm).
bool beginsWord(std::string_view name, std::size_t at) {
  if (at == 0 || !isLetter(name[at - 1])) return true;
  if (!isUpper(name[at])) return false;
  return isLower(name[at - 1]) || (at + 1 < name.size() && isLower(name[at + 1]));
}

/// Letters beyond ASCII belong to the word next to them.
bool isForeign(std::string_view name, std::size_t at) {
  return at < name.size() && (static_cast<unsigned char>(name[at]) & 0x80u) != 0;
}

/// Inside a word at least three letters must come before, since "bright", "upright" and "cleft" name no side.
bool staysApart(std::string_view name, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && !beginsWord(name, begin)) --begin;
  return begin == at || at - begin >= 3;
}

void addWholeWords(std::string_view name, const std::string& lower, std::vector<SideMarker>& markers) {
  for (const auto& [text, side] : {std::pair{kWords.left, Side::kLeft}, std::pair{kWords.right, Side::kRight}}) {
    for (std::size_t at = lower.find(text); at != std::string::npos; at = lower.find(text, at + text.size())) {
      if (staysApart(name, at)) markers.push_back({at, text.size(), side});
    }
  }
  std::ranges::sort(markers, {}, &SideMarker::begin);
}

void addShort(std::string_view name, const std::string& lower, std::vector<SideMarker>& markers) {
  for (std::size_t begin = 0; begin < name.size(); ++begin) {
    if (!isLetter(name[begin]) || !beginsWord(name, begin) || (begin > 0 && isForeign(name, begin - 1))) continue;
    std::size_t end = begin + 1;
    while (end < name.size() && isLetter(name[end]) && !beginsWord(name, end)) ++end;
    if (isForeign(name, end)) continue;
    const std::string_view word = std::string_view(lower).substr(begin, end - begin);
    for (const MarkerPair& pair : kShort) {
      if (word == pair.left) markers.push_back({begin, end - begin, Side::kLeft});
      if (word == pair.right) markers.push_back({begin, end - begin, Side::kRight});
    }
  }
}

/// `text` in the case of `like`: all capitals, a leading capital, or lower case.
std::string inCaseOf(std::string_view text, std::string_view like) {
  std::string result(text);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (isUpper(like[std::min(i, like.size() - 1)])) result[i] = static_cast<char>(result[i] - 'a' + 'A');
  }
  return result;
}

std::string_view opposite(std::string_view lowerMarker) {
  const auto of = [&](const MarkerPair& pair) {
    return lowerMarker == pair.left ? pair.right : (lowerMarker == pair.right ? pair.left : std::string_view());
  };
  if (const std::string_view word = of(kWords); !word.empty()) return word;
  for (const MarkerPair& pair : kShort) {
    if (const std::string_view text = of(pair); !text.empty()) return text;
  }
  return lowerMarker;
}

}  // namespace

std::vector<SideMarker> sideMarkers(std::string_view name) {
  const std::string lower = lowerCase(name);
  std::vector<SideMarker> markers;
  addWholeWords(name, lower, markers);
  if (markers.empty()) addShort(name, lower, markers);
  return markers;
}

std::optional<Side> sideNamed(std::string_view name) {
  const std::vector<SideMarker> markers = sideMarkers(name);
  const auto left = std::ranges::count(markers, Side::kLeft, &SideMarker::side);
  const auto right = std::ranges::count(markers, Side::kRight, &SideMarker::side);
  if (left == right) return std::nullopt;
  return left > right ? Side::kLeft : Side::kRight;
}

std::string withoutSide(const std::string& name) {
  const std::vector<SideMarker> markers = sideMarkers(name);
  if (markers.size() != 1) return name;
  std::string text = name;
  text.erase(markers[0].begin, markers[0].length);
  const auto parts = [](char c) { return c == ' ' || c == '.' || c == '_' || c == '-'; };
  while (!text.empty() && parts(text.back())) text.pop_back();
  while (!text.empty() && parts(text.front())) text.erase(0, 1);
  return text.empty() ? name : text;
}

std::optional<std::string> mirroredName(std::string_view name) {
  const std::vector<SideMarker> markers = sideMarkers(name);
  if (markers.size() != 1) return std::nullopt;
  const std::string_view marker = name.substr(markers[0].begin, markers[0].length);
  std::string result(name.substr(0, markers[0].begin));
  result += inCaseOf(opposite(lowerCase(marker)), marker);
  result += name.substr(markers[0].begin + markers[0].length);
  return result;
}

std::string lettersOf(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (isLetter(c)) letters.push_back(toLower(c));
  }
  return letters;
}

std::vector<std::string> wordsOf(std::string_view name) {
  std::vector<std::string> words;
  bool inWord = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!isLetter(name[i])) {
      inWord = false;
      continue;
    }
    const bool capital = i > 0 && isUpper(name[i]) && isLetter(name[i - 1]) && !isUpper(name[i - 1]);
    if (!inWord || capital) words.emplace_back();
    words.back().push_back(toLower(name[i]));
    inWord = true;
  }
  return words;
}

namespace {

using Words = std::initializer_list<std::string_view>;

// Keys --------------------------------------------------------------------------------------------------------------

/// Longer ones first, since they contain shorter ones.
constexpr std::array<std::pair<std::string_view, std::string_view>, 29> kJapanese{{
    {"全ての親", " root "},    {"センター", " center "}, {"グルーブ", " groove "}, {"上半身", " upperbody "},
    {"下半身", " lowerbody "}, {"つま先", " toes "},     {"足先EX", " toes "},     {"足首", " foot "},
    {"手首", " hand "},        {"ひじ", " lowerarm "},   {"肘", " lowerarm "},     {"ひざ", " lowerleg "},
    {"膝", " lowerleg "},      {"手捩", " twist "},      {"腕捩", " twist "},      {"親指", " thumb "},
    {"人指", " finger "},      {"中指", " finger "},     {"薬指", " finger "},     {"小指", " finger "},
    {"ＩＫ", " ik "},          {"左", "left "},          {"右", "right "},         {"首", " neck "},
    {"頭", " head "},          {"肩", " shoulder "},     {"腕", " upperarm "},     {"足", " upperleg "},
    {"腰", " waist "},
}};

bool isOneOf(std::string_view word, Words words) { return std::ranges::find(words, word) != words.end(); }

bool holds(std::string_view key, Words words) {
  return std::ranges::any_of(words, [&](auto word) { return key.find(word) != std::string_view::npos; });
}

/// Only says that it is a bone, or which program made it.
bool saysNothing(std::string_view word) {
  return isOneOf(word, {"bip", "def", "mixamorig", "valvebiped", "jnt", "joint", "bone", "skel", "bind", "bn", "cc",
                        "j", "b", "c", "rig", "m", "cf"});
}

bool helps(std::string_view word) {
  return isOneOf(word, {"twist", "roll",     "share", "stretch", "adj",   "corrective", "ik",       "mch", "org",
                        "wgt",   "bendy",    "pole",  "target",  "ctrl",  "control",    "socket",   "nub", "end",
                        "tip",   "effector", "null",  "helper",  "dummy", "poletarget", "twistbone"});
}

/// The name with its side markers replaced by spaces; those of animals' legs by front or back.
std::string withoutSide(std::string_view name) {
  std::string text(name);
  const std::vector<SideMarker> markers = sideMarkers(name);
  for (auto marker = markers.rbegin(); marker != markers.rend(); ++marker) {
    const std::string word = lettersOf(name.substr(marker->begin, marker->length));
    const char* leg = word == "fl" || word == "fr" ? " front " : (word == "bl" || word == "br" ? " back " : " ");
    text.replace(marker->begin, marker->length, leg);
  }
  return text;
}

struct Split {
  BoneName name;
  std::vector<std::string> words;
};

Split split(const std::string& full) {
  Split result;
  std::string own = inEnglish(full);
  if (const std::size_t cut = own.find_last_of(":|"); cut != std::string::npos) own.erase(0, cut + 1);
  result.name.side = sideNamed(own);
  for (std::string& word : wordsOf(withoutSide(own))) {
    for (const auto& [romaji, side] : {std::pair{"hidari", Side::kLeft}, std::pair{"migi", Side::kRight}}) {
      if (!word.starts_with(romaji)) continue;
      word.erase(0, std::string_view(romaji).size());
      result.name.side = side;
    }
    if (helps(word)) result.name.helper = true;
    if (!word.empty() && !saysNothing(word)) result.words.push_back(std::move(word));
  }
  return result;
}

/// A first word that most names share.
std::string sharedPrefix(const std::vector<Split>& names) {
  std::map<std::string, std::size_t> counts;
  for (const Split& name : names) {
    if (!name.words.empty()) ++counts[name.words.front()];
  }
  for (const auto& [word, count] : counts) {
    if (names.size() >= 5 && 5 * count >= 4 * names.size()) return word;
  }
  return {};
}

// Words for parts ---------------------------------------------------------------------------------------------------

struct Vocabulary {
  Slot slot;
  Words usual;    ///< 3
  Words some;     ///< 2
  Words perhaps;  ///< 1
};

std::span<const Vocabulary> vocabularies() {
  static const std::array<Vocabulary, kSlotCount> kAll{{
      {Slot::kHips, {"hips", "pelvis", "lowerbody", "kahanshin"}, {"hip", "koshi"}, {"cog", "waist"}},
      {Slot::kSpine,
       {"spine", "abdomen", "abdomenlower", "spinelower", "upperbody", "jouhanshin", "joubanshin"},
       {"waist", "stomach", "belly", "spinea", "torso", "back"},
       {"chest", "abdomenupper"}},
      {Slot::kChest,
       {"chest", "chestlower", "ribcage", "thorax", "mune"},
       {"spine", "torso", "abdomenupper", "spinemiddle", "spineb"},
       {"upperbody"}},
      {Slot::kUpperChest,
       {"upperchest", "chestupper"},
       {"chest", "spine", "spineupper", "spinec"},
       {"torso", "ribcage"}},
      {Slot::kNeck, {"neck", "necklower", "necktwist", "kubi"}, {}, {"cervical"}},
      {Slot::kHead, {"head", "atama", "skull"}, {}, {}},
      {Slot::kTail, {"tail", "shippo"}, {}, {}},
      {Slot::kShoulder,
       {"clavicle", "collar", "collarbone", "shoulder", "scapula", "kata", "shoulderblade", "frontshoulder"},
       {},
       {}},
      {Slot::kUpperArm,
       {"upperarm", "uparm", "armupper", "humerus", "shldr", "shldrbend", "ude"},
       {"arm"},
       {"shoulder"}},
      {Slot::kLowerArm,
       {"forearm", "lowerarm", "lowarm", "armlower", "elbow", "forearmbend", "radius", "hiji", "frontlowleg"},
       {},
       {}},
      {Slot::kHand, {"hand", "wrist", "tekubi"}, {"te", "frontfoot"}, {}},
      {Slot::kUpperLeg,
       {"thigh", "upperleg", "upleg", "legupper", "femur", "thighbend", "ashi"},
       {"hip", "hipjoint", "backupleg"},
       {"leg"}},
      {Slot::kLowerLeg,
       {"calf", "shin", "lowerleg", "lowleg", "leglower", "knee", "tibia", "hiza", "backlowleg"},
       {"leg"},
       {}},
      {Slot::kFoot, {"foot", "ankle", "ashikubi", "backfoot"}, {}, {"heel"}},
      {Slot::kToes, {"toe", "toes", "toebase", "ball", "tsumasaki"}, {}, {}},
      {Slot::kFrontUpper,
       {"upperarm", "humerus", "frontupperarm"},
       {"arm"},
       {"frontupperleg", "frontupleg", "upperlegfront", "foreupperleg"}},
      {Slot::kFrontLower,
       {"forearm", "lowerarm", "radius", "elbow"},
       {},
       {"frontlowerleg", "frontlowleg", "lowerlegfront", "forelowerleg"}},
      {Slot::kFrontFoot,
       {"hand", "wrist", "carpus", "cannonfront", "frontcannon", "metacarpus"},
       {"cannon", "frontfoot", "paw"},
       {"foot", "frontpaw"}},
      {Slot::kHindUpper, {"thigh", "femur"}, {}, {}},
      {Slot::kHindLower, {"shin", "tibia", "gaskin", "calf", "stifle"}, {}, {}},
      {Slot::kHindFoot, {"cannonhind", "hindcannon", "metatarsus", "hock"}, {"cannon"}, {}},
  }};
  return kAll;
}

/// True also if both are center parts.
bool isSameLimb(Slot a, Slot b) {
  const auto limb = [](Slot slot) {
    if (slot < kFirstSidedSlot) return 0;
    if (slot <= Slot::kHand) return 1;
    if (slot <= Slot::kToes) return 2;
    return slot <= Slot::kFrontFoot ? 3 : 4;
  };
  const bool shoulder = a == Slot::kShoulder || b == Slot::kShoulder;
  const int other = limb(a == Slot::kShoulder ? b : a);
  return shoulder ? other == 1 || other == 3 : limb(a) == limb(b);
}

int wordFits(std::string_view key, const Vocabulary& words) {
  if (isOneOf(key, words.usual)) return 3;
  if (isOneOf(key, words.some)) return 2;
  return isOneOf(key, words.perhaps) ? 1 : 0;
}

}  // namespace

std::string inEnglish(std::string name) {
  for (const auto& [japanese, english] : kJapanese) {
    for (std::size_t at = name.find(japanese); at != std::string::npos; at = name.find(japanese, at + english.size())) {
      name.replace(at, japanese.size(), english);
    }
  }
  return name;
}

std::vector<BoneName> boneNames(const Skeleton& skeleton) {
  std::vector<Split> splits;
  for (const Bone& bone : skeleton.bones) splits.push_back(split(bone.name));
  const std::string shared = sharedPrefix(splits);
  std::vector<BoneName> names;
  for (Split& one : splits) {
    for (std::size_t i = 0; i < one.words.size(); ++i) {
      if (i == 0 && (one.words[i] == shared)) continue;
      one.name.key += one.words[i];
    }
    const std::string& key = one.name.key;
    one.name.helper = one.name.helper || holds(key, {"twist", "poletarget", "corrective"});
    one.name.digit = holds(key, {"finger", "palm", "thumb", "index", "pinky", "pinkie", "bigtoe", "smalltoe", "midtoe",
                                 "ringtoe"}) ||
                     isOneOf(key, {"middle", "mid", "ring", "little", "carpal", "oyayubi", "yubi"});
    names.push_back(std::move(one.name));
  }
  return names;
}

int nameFits(const BoneName& name, Slot slot) {
  if (name.key.empty()) return 0;
  if (name.digit) return -3;
  int best = 0;
  int elsewhere = 0;
  for (const Vocabulary& words : vocabularies()) {
    const int fit = wordFits(name.key, words);
    if (words.slot == slot) best = fit;
    else if (isSameLimb(words.slot, slot)) elsewhere = std::max(elsewhere, fit);
  }
  if (best == 0 && elsewhere > 0) return -elsewhere;
  return best;
}

LimbWord limbWord(const BoneName& name) {
  const std::string_view key = name.key;
  if (name.digit || name.helper) return LimbWord::kNone;
  const bool leg = holds(key, {"leg", "thigh", "knee", "shin", "calf", "foot", "ankle", "femur", "tibia", "paw", "hoof",
                               "toe", "cannon", "hiza", "ashi", "pastern"}) ||
                   (name.side && (key == "hip" || key == "ball"));
  const bool arm = !leg && holds(key, {"arm", "elbow", "hand", "wrist", "shoulder", "clavicle", "collar", "humerus",
                                       "scapula", "shldr", "hiji", "tekubi"});
  if (leg && holds(key, {"front", "fore"})) return LimbWord::kFrontLeg;
  if (leg && holds(key, {"back", "hind", "rear"})) return LimbWord::kHindLeg;
  if (leg) return LimbWord::kLeg;
  return arm || key == "ude" || key == "kata" ? LimbWord::kArm : LimbWord::kNone;
}

}  // namespace sinew
