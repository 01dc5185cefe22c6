// shaders/compute/unsure.glsl: the list of vertices whose first root single precision cannot vouch for. Its order is
// any: each is worked on alone. `groups` is what a dispatch over the list reads; a long list goes around.
layout(std430, binding = 5) buffer Unsure {
  uvec4 groups;  // x, y, z and how many there are.
  uint unsure[];
};

const uint kMostGroups = 1024u;

void leaveUnsure(uint vertex) {
  uint place = atomicAdd(groups.w, 1u);
  unsure[place] = vertex;
  atomicMax(groups.x, min(place / gl_WorkGroupSize.x + 1u, kMostGroups));
}
