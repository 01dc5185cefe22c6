// shaders/compute/rounds.glsl: a round that changes something asks for the next one: for the groups of its
// dispatches. What nobody asks for has none, and costs nothing.
struct Round {
  uvec4 vertexGroups;
  uvec4 triangleGroups;
};
layout(std430, binding = ROUNDS) writeonly buffer Rounds { Round rounds[]; };
uniform int round;

void askForNext() { rounds[round + 1] = Round(vertexGroups, triangleGroups); }
