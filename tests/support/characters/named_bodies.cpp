// tests/support/characters/named_bodies.cpp: the joints of a body, and their names in each program.
#include "tests/support/characters/named_bodies.h"

#include "tests/support/characters/character_parts.h"

namespace sinew::test {
namespace {

using Places = std::map<std::string, glm::vec3>;

Places placesOf(bool quadruped, Stance stance) {
  if (quadruped) {
    return {{"ground", {0, 0, 0}},
            {"hips", {0, 1.3f, -.5f}},
            {"spine", {0, 1.35f, -.25f}},
            {"spine2", {0, 1.33f, .05f}},
            {"chest", {0, 1.3f, .3f}},
            {"neck", {0, 1.45f, .55f}},
            {"neck2", {0, 1.7f, .75f}},
            {"head", {0, 1.95f, .9f}},
            {"tail", {0, 1.35f, -.75f}},
            {"tail2", {0, 1.1f, -.9f}},
            {"scapula", {.1f, 1.4f, .35f}},
            {"shoulder", {.17f, 1.05f, .5f}},
            {"elbow", {.16f, .85f, .35f}},
            {"carpus", {.15f, .45f, .38f}},
            {"pastern", {.15f, .2f, .38f}},
            {"hoof", {.15f, .08f, .42f}},
            {"pelvisside", {.05f, 1.3f, -.5f}},
            {"hip", {.14f, 1.28f, -.52f}},
            {"stifle", {.15f, .95f, -.4f}},
            {"hock", {.14f, .55f, -.7f}},
            {"pasternhind", {.14f, .22f, -.66f}},
            {"hoofhind", {.14f, .08f, -.6f}},
            {"pole", {.15f, .6f, 1.5f}}};
  }
  Places places{{"ground", {0, 0, 0}},        {"hips", {0, .96f, 0}},           {"pelvis", {0, .95f, 0}},
                {"spine", {0, 1.06f, 0}},     {"spine2", {0, 1.16f, 0}},        {"spine3", {0, 1.26f, -.01f}},
                {"chest", {0, 1.34f, -.01f}}, {"neck", {0, 1.47f, -.02f}},      {"neck2", {0, 1.52f, -.02f}},
                {"head", {0, 1.58f, 0}},      {"headtop", {0, 1.8f, 0}},        {"eye", {.03f, 1.66f, .08f}},
                {"collar", {.03f, 1.43f, 0}}, {"hip", {.09f, .92f, 0}},         {"midthigh", {.095f, .7f, .005f}},
                {"knee", {.1f, .5f, .01f}},   {"midshin", {.105f, .3f, -.01f}}, {"ankle", {.11f, .08f, -.03f}},
                {"ball", {.115f, .02f, .1f}}, {"toetip", {.12f, .01f, .17f}},   {"heel", {.11f, .01f, -.06f}},
                {"pole", {.1f, .5f, .9f}},    {"breast", {.08f, 1.3f, .1f}},    {"tail", {0, .95f, -.12f}}};
  const glm::vec3 shoulder(.17f, 1.43f, -.01f);
  const glm::vec3 along =
      stance == Stance::kArmsLevel ? glm::vec3(1, 0, 0) : glm::normalize(glm::vec3(.6f, -.8f, .02f));
  places["shoulder"] = shoulder;
  for (const auto& [name, far] : std::initializer_list<std::pair<const char*, float>>{{"midarm", .14f},
                                                                                      {"elbow", .28f},
                                                                                      {"midforearm", .4f},
                                                                                      {"wrist", .53f},
                                                                                      {"finger", .62f},
                                                                                      {"finger2", .66f}}) {
    places[name] = shoulder + far * along;
  }
  places["thumb"] = shoulder + .57f * along + glm::vec3(0, 0, .04f);
  return places;
}

std::vector<NamedBone> mixamo(const std::string& p) {
  return {{p + "Hips", "", "hips", "hips"},
          {p + "Spine", p + "Hips", "spine", "spine"},
          {p + "Spine1", p + "Spine", "spine2", "chest"},
          {p + "Spine2", p + "Spine1", "spine3", "upperChest"},
          {p + "Neck", p + "Spine2", "neck", "neck"},
          {p + "Head", p + "Neck", "head", "head"},
          {p + "HeadTop_End", p + "Head", "headtop"},
          {p + "LeftShoulder", p + "Spine2", "collar", "shoulder"},
          {p + "LeftArm", p + "LeftShoulder", "shoulder", "upperArm"},
          {p + "LeftForeArm", p + "LeftArm", "elbow", "lowerArm"},
          {p + "LeftHand", p + "LeftForeArm", "wrist", "hand"},
          {p + "LeftHandThumb1", p + "LeftHand", "thumb"},
          {p + "LeftHandIndex1", p + "LeftHand", "finger"},
          {p + "LeftHandIndex2", p + "LeftHandIndex1", "finger2"},
          {p + "LeftUpLeg", p + "Hips", "hip", "upperLeg"},
          {p + "LeftLeg", p + "LeftUpLeg", "knee", "lowerLeg"},
          {p + "LeftFoot", p + "LeftLeg", "ankle", "foot"},
          {p + "LeftToeBase", p + "LeftFoot", "ball", "toes"},
          {p + "LeftToe_End", p + "LeftToeBase", "toetip"}};
}

/// A body of the usual 22 parts: a name for each, "" where the style has none.
struct Plain {
  std::string root, hips, spine, chest, upperChest, neck, head, shoulder, upperArm, lowerArm, hand, upperLeg, lowerLeg,
      foot, toes;
};

std::vector<NamedBone> plain(const Plain& n) {
  std::vector<NamedBone> bones;
  const auto add = [&](const std::string& name, const std::string& parent, const char* place, const char* slot) {
    if (!name.empty()) bones.push_back({name, parent, place, slot});
    return name.empty() ? parent : name;
  };
  const std::string root = add(n.root, "", "ground", "");
  const std::string hips = add(n.hips, root, "hips", "hips");
  const std::string spine = add(n.spine, hips, "spine", "spine");
  const std::string chest = add(n.chest, spine, "spine2", "chest");
  const std::string upper = add(n.upperChest, chest, "spine3", "upperChest");
  const std::string neck = add(n.neck, upper, "neck", "neck");
  add(n.head, neck, "head", "head");
  const std::string collar = add(n.shoulder, upper, "collar", "shoulder");
  const std::string arm = add(n.upperArm, collar, "shoulder", "upperArm");
  const std::string forearm = add(n.lowerArm, arm, "elbow", "lowerArm");
  add(n.hand, forearm, "wrist", "hand");
  const std::string thigh = add(n.upperLeg, hips, "hip", "upperLeg");
  const std::string shin = add(n.lowerLeg, thigh, "knee", "lowerLeg");
  const std::string foot = add(n.foot, shin, "ankle", "foot");
  add(n.toes, foot, "ball", "toes");
  return bones;
}

void addTo(std::vector<NamedBone>& bones, std::vector<NamedBone> more) {
  bones.insert(bones.end(), more.begin(), more.end());
}

std::vector<NamedBone> unreal() {
  std::vector<NamedBone> bones =
      plain({"root", "pelvis", "spine_01", "spine_02", "spine_03", "neck_01", "head", "clavicle_l", "upperarm_l",
             "lowerarm_l", "hand_l", "thigh_l", "calf_l", "foot_l", "ball_l"});
  addTo(bones, {{"upperarm_twist_01_l", "upperarm_l", "midarm"},
                {"lowerarm_twist_01_l", "lowerarm_l", "midforearm"},
                {"thigh_twist_01_l", "thigh_l", "midthigh"},
                {"calf_twist_01_l", "calf_l", "midshin"},
                {"index_01_l", "hand_l", "finger"},
                {"thumb_01_l", "hand_l", "thumb"},
                {"ik_foot_root", "root", "ground"},
                {"ik_foot_l", "ik_foot_root", "ankle"},
                {"ik_hand_root", "root", "ground"},
                {"ik_hand_gun", "ik_hand_root", "ground"}});
  return bones;
}

std::vector<NamedBone> biped(const std::string& p) {
  return {{p, "", "hips"},
          {p + " Pelvis", p, "pelvis", "hips"},
          {p + " Spine", p + " Pelvis", "spine", "spine"},
          {p + " Spine1", p + " Spine", "spine3", "chest"},
          {p + " Neck", p + " Spine1", "neck", "neck"},
          {p + " Head", p + " Neck", "head", "head"},
          {p + " HeadNub", p + " Head", "headtop"},
          {p + " L Clavicle", p + " Neck", "collar", "shoulder"},
          {p + " L UpperArm", p + " L Clavicle", "shoulder", "upperArm"},
          {p + " L Forearm", p + " L UpperArm", "elbow", "lowerArm"},
          {p + " L Hand", p + " L Forearm", "wrist", "hand"},
          {p + " L Finger0", p + " L Hand", "thumb"},
          {p + " L Finger1", p + " L Hand", "finger"},
          {p + " L Thigh", p + " Pelvis", "hip", "upperLeg"},
          {p + " L Calf", p + " L Thigh", "knee", "lowerLeg"},
          {p + " L Foot", p + " L Calf", "ankle", "foot"},
          {p + " L Toe0", p + " L Foot", "ball", "toes"},
          {p + " L Toe0Nub", p + " L Toe0", "toetip"}};
}

std::vector<NamedBone> rigify(const std::string& p, bool split) {
  const auto n = [&](const std::string& name) { return p + name; };
  const std::string half = split ? ".001" : "";
  std::vector<NamedBone> bones{{n("spine"), "", "hips", "hips"},
                               {n("spine.001"), n("spine"), "spine", "spine"},
                               {n("spine.002"), n("spine.001"), "spine2", "chest"},
                               {n("spine.003"), n("spine.002"), "spine3", "upperChest"},
                               {n("spine.004"), n("spine.003"), "neck", "neck"},
                               {n("spine.005"), n("spine.004"), "neck2"},
                               {n("spine.006"), n("spine.005"), "head", "head"},
                               {n("pelvis.L"), n("spine"), "hip"},
                               {n("breast.L"), n("spine.003"), "breast"},
                               {n("shoulder.L"), n("spine.003"), "collar", "shoulder"},
                               {n("upper_arm.L"), n("shoulder.L"), "shoulder", "upperArm"}};
  if (split) bones.push_back({n("upper_arm.L.001"), n("upper_arm.L"), "midarm"});
  bones.push_back({n("forearm.L"), n("upper_arm.L" + half), "elbow", "lowerArm"});
  if (split) bones.push_back({n("forearm.L.001"), n("forearm.L"), "midforearm"});
  addTo(bones, {{n("hand.L"), n("forearm.L" + half), "wrist", "hand"},
                {n("palm.01.L"), n("hand.L"), "finger"},
                {n("f_index.01.L"), n("palm.01.L"), "finger2"},
                {n("thumb.01.L"), n("hand.L"), "thumb"},
                {n("thigh.L"), n("spine"), "hip", "upperLeg"}});
  if (split) bones.push_back({n("thigh.L.001"), n("thigh.L"), "midthigh"});
  bones.push_back({n("shin.L"), n("thigh.L" + half), "knee", "lowerLeg"});
  if (split) bones.push_back({n("shin.L.001"), n("shin.L"), "midshin"});
  addTo(bones, {{n("foot.L"), n("shin.L" + half), "ankle", "foot"}, {n("toe.L"), n("foot.L"), "ball", "toes"}});
  if (!split) bones.push_back({n("heel.02.L"), n("foot.L"), "heel"});
  return bones;
}

std::vector<NamedBone> daz() {
  return {{"hip", "", "hips"},
          {"pelvis", "hip", "pelvis", "hips"},
          {"lThighBend", "pelvis", "hip", "upperLeg"},
          {"lThighTwist", "lThighBend", "midthigh"},
          {"lShin", "lThighTwist", "knee", "lowerLeg"},
          {"lFoot", "lShin", "ankle", "foot"},
          {"lMetatarsals", "lFoot", "heel"},
          {"lToe", "lFoot", "ball", "toes"},
          {"lBigToe", "lToe", "toetip"},
          {"abdomenLower", "hip", "spine", "spine"},
          {"abdomenUpper", "abdomenLower", "spine2"},
          {"chestLower", "abdomenUpper", "spine3", "chest"},
          {"chestUpper", "chestLower", "chest", "upperChest"},
          {"lCollar", "chestUpper", "collar", "shoulder"},
          {"lShldrBend", "lCollar", "shoulder", "upperArm"},
          {"lShldrTwist", "lShldrBend", "midarm"},
          {"lForearmBend", "lShldrTwist", "elbow", "lowerArm"},
          {"lForearmTwist", "lForearmBend", "midforearm"},
          {"lHand", "lForearmTwist", "wrist", "hand"},
          {"lThumb1", "lHand", "thumb"},
          {"lCarpal1", "lHand", "finger"},
          {"lIndex1", "lCarpal1", "finger2"},
          {"neckLower", "chestUpper", "neck", "neck"},
          {"neckUpper", "neckLower", "neck2"},
          {"head", "neckUpper", "head", "head"},
          {"lEye", "head", "eye"}};
}

std::vector<NamedBone> characterCreator() {
  const std::string p = "CC_Base_";
  return {{p + "BoneRoot", "", "ground"},
          {p + "Hip", p + "BoneRoot", "hips"},
          {p + "Pelvis", p + "Hip", "pelvis", "hips"},
          {p + "L_Thigh", p + "Pelvis", "hip", "upperLeg"},
          {p + "L_ThighTwist01", p + "L_Thigh", "midthigh"},
          {p + "L_Calf", p + "L_Thigh", "knee", "lowerLeg"},
          {p + "L_CalfTwist01", p + "L_Calf", "midshin"},
          {p + "L_KneeShareBone", p + "L_Calf", "knee"},
          {p + "L_Foot", p + "L_Calf", "ankle", "foot"},
          {p + "L_ToeBaseShareBone", p + "L_Foot", "ball"},
          {p + "L_ToeBase", p + "L_Foot", "ball", "toes"},
          {p + "Waist", p + "Hip", "spine", "spine"},
          {p + "Spine01", p + "Waist", "spine2", "chest"},
          {p + "Spine02", p + "Spine01", "spine3", "upperChest"},
          {p + "NeckTwist01", p + "Spine02", "neck", "neck"},
          {p + "NeckTwist02", p + "NeckTwist01", "neck2"},
          {p + "Head", p + "NeckTwist02", "head", "head"},
          {p + "L_Eye", p + "Head", "eye"},
          {p + "L_Breast", p + "Spine02", "breast"},
          {p + "L_Clavicle", p + "Spine02", "collar", "shoulder"},
          {p + "L_Upperarm", p + "L_Clavicle", "shoulder", "upperArm"},
          {p + "L_UpperarmTwist01", p + "L_Upperarm", "midarm"},
          {p + "L_Forearm", p + "L_Upperarm", "elbow", "lowerArm"},
          {p + "L_ForearmTwist01", p + "L_Forearm", "midforearm"},
          {p + "L_ElbowShareBone", p + "L_Forearm", "elbow"},
          {p + "L_Hand", p + "L_Forearm", "wrist", "hand"},
          {p + "L_Thumb1", p + "L_Hand", "thumb"},
          {p + "L_Index1", p + "L_Hand", "finger"}};
}

std::vector<NamedBone> mmd() {
  return {{"全ての親", "", "ground"},
          {"センター", "全ての親", "hips"},
          {"上半身", "センター", "spine", "spine"},
          {"上半身2", "上半身", "spine3", "chest"},
          {"首", "上半身2", "neck", "neck"},
          {"頭", "首", "head", "head"},
          {"左目", "頭", "eye"},
          {"左肩", "上半身2", "collar", "shoulder"},
          {"左腕", "左肩", "shoulder", "upperArm"},
          {"左腕捩", "左腕", "midarm"},
          {"左ひじ", "左腕", "elbow", "lowerArm"},
          {"左手捩", "左ひじ", "midforearm"},
          {"左手首", "左ひじ", "wrist", "hand"},
          {"左親指１", "左手首", "thumb"},
          {"左人指１", "左手首", "finger"},
          {"下半身", "センター", "pelvis", "hips"},
          {"左足", "下半身", "hip", "upperLeg"},
          {"左ひざ", "左足", "knee", "lowerLeg"},
          {"左足首", "左ひざ", "ankle", "foot"},
          {"左つま先", "左足首", "ball", "toes"},
          {"左足ＩＫ", "全ての親", "ankle"}};
}

std::vector<NamedBone> vroid() {
  const std::string p = "J_Bip_";
  std::vector<NamedBone> bones =
      plain({"Root", p + "C_Hips", p + "C_Spine", p + "C_Chest", p + "C_UpperChest", p + "C_Neck", p + "C_Head",
             p + "L_Shoulder", p + "L_UpperArm", p + "L_LowerArm", p + "L_Hand", p + "L_UpperLeg", p + "L_LowerLeg",
             p + "L_Foot", p + "L_ToeBase"});
  addTo(bones, {{"J_Sec_L_Bust1", p + "C_UpperChest", "breast"},
                {p + "L_Thumb1", p + "L_Hand", "thumb"},
                {p + "L_Index1", p + "L_Hand", "finger"},
                {"J_Adj_L_FaceEye", p + "C_Head", "eye"}});
  for (int i = 1; i < 9; ++i) {
    const auto hair = [](int k) { return "J_Sec_Hair" + std::to_string(k); };
    bones.push_back({hair(i), i == 1 ? p + "C_Head" : hair(i - 1), "headtop"});
  }
  return bones;
}

/// Bones with meaningless names; the left ones end in 1, the right ones in 2. Ends, which move no skin, are omitted.
std::vector<NamedBone> numbered(std::vector<NamedBone> bones, const std::string& left) {
  std::erase_if(bones, [](const NamedBone& bone) { return bone.name.ends_with("_End"); });
  std::map<std::string, std::string> names{{"", ""}};
  int next = 3;
  for (const NamedBone& bone : bones) {
    const bool sided = bone.name.find(left) != std::string::npos;
    names[bone.name] = "joint " + std::to_string(next++) + (sided ? "-1" : "");
  }
  for (NamedBone& bone : bones) {
    bone.name = names[bone.name];
    bone.parent = names[bone.parent];
  }
  return bones;
}

}  // namespace

std::vector<NamedBody> namedBodies() {
  std::vector<NamedBone> quaternius = plain({"Root", "Hips", "Abdomen", "Torso", "Chest", "Neck", "Head", "Shoulder.L",
                                             "UpperArm.L", "LowerArm.L", "Hand.L", "UpperLeg.L", "LowerLeg.L", "", ""});
  addTo(quaternius,
        {{"Foot.L", "Root", "ankle", "foot"}, {"PoleTarget.L", "Root", "pole"}, {"Index1.L", "Hand.L", "finger"}});
  std::vector<NamedBone> cesium = plain({"", "Hips", "Spine", "", "", "Neck", "Head", "", "LeftArm", "LeftForeArm",
                                         "LeftHand", "LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToeBase"});
  for (NamedBone& bone : cesium) {
    if (bone.slot == "spine") bone.place = "chest";
  }
  std::vector<NamedBody> bodies{
      {"Mixamo", "Left", "Right", mixamo("mixamorig:")},
      {"Mixamo, several in a scene", "Left", "Right", mixamo("mixamorig7:")},
      {"Mixamo without colon", "Left", "Right", mixamo("mixamorig")},
      {"Mixamo without prefix", "Left", "Right", mixamo("")},
      {"Mixamo in an armature", "Left", "Right", mixamo("Armature|mixamorig:")},
      {"VRM", "left", "right",
       plain({"", "hips", "spine", "chest", "upperChest", "neck", "head", "leftShoulder", "leftUpperArm",
              "leftLowerArm", "leftHand", "leftUpperLeg", "leftLowerLeg", "leftFoot", "leftToes"})},
      {"VRoid", "_L_", "_R_", vroid()},
      {"Unreal", "_l", "_r", unreal()},
      {"Biped", " L ", " R ", biped("Bip01")},
      {"Biped of a newer file", " L ", " R ", biped("Bip001")},
      {"Rigify metarig", ".L", ".R", rigify("", false)},
      {"Rigify deforming bones", ".L", ".R", rigify("DEF-", true)},
      {"Daz", "l", "r", daz()},
      {"Character Creator", "_L_", "_R_", characterCreator()},
      {"MMD", "左", "右", mmd()},
      {"Romaji", "hidari", "migi",
       plain({"", "koshi", "jouhanshin", "mune", "", "kubi", "atama", "hidari_kata", "hidari_ude", "hidari_hiji",
              "hidari_tekubi", "hidari_ashi", "hidari_hiza", "hidari_ashikubi", "hidari_tsumasaki"})},
      {"Motion capture", "Left", "Right",
       plain({"", "Hips", "Chest", "Chest2", "", "Neck", "Head", "LeftCollar", "LeftShoulder", "LeftElbow", "LeftWrist",
              "LeftHip", "LeftKnee", "LeftAnkle", "LeftToe"})},
      {"Quaternius", ".L", ".R", quaternius},
      {"Unnamed", "-1", "-2", numbered(cesium, "Left")},
      {"Unnamed with collar bones", "-1", "-2", numbered(mixamo("mixamorig:"), "Left")},

  };
  for (NamedBody& animal : namedAnimals()) bodies.push_back(std::move(animal));
  return bodies;
}

Character characterOf(const NamedBody& body, Stance stance, std::map<std::string, std::string>& expected) {
  const Places places = placesOf(body.quadruped, stance);
  Character character;
  character.name = body.style;
  character.height = body.quadruped ? 2.0f : 1.8f;
  std::map<std::string, int> indices;
  const auto onRight = [&](std::string name) {
    // In Daz's names the side is the first letter, and others may hold it too.
    const std::size_t at = body.left == "l"
                               ? (name[0] == 'l' && name.size() > 1 && name[1] < 'a' ? 0 : std::string::npos)
                               : name.rfind(body.left);
    if (at == std::string::npos) return std::string();
    return name.replace(at, body.left.size(), body.right);
  };
  const auto add = [&](const std::string& name, const std::string& parent, const glm::vec3& joint) {
    indices[name] = static_cast<int>(character.skeleton.bones.size());
    addBone(character.skeleton, name, parent.empty() ? -1 : indices.at(parent), joint);
  };
  for (const NamedBone& bone : body.bones) {
    const glm::vec3 joint = places.at(bone.place);
    const std::string right = onRight(bone.name);
    add(bone.name, bone.parent, joint);
    if (!bone.slot.empty()) expected[bone.slot + (right.empty() ? "" : ".L")] = bone.name;
    if (right.empty()) continue;
    const std::string parent = onRight(bone.parent);
    add(right, parent.empty() ? bone.parent : parent, {-joint.x, joint.y, joint.z});
    if (!bone.slot.empty()) expected[bone.slot + ".R"] = right;
  }
  finishBones(character.skeleton);
  return character;
}

}  // namespace sinew::test
