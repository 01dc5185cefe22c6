// shaders/relief.glsl: normal maps without tangents in the mesh: the frame comes from how position and texture
// coordinates change from pixel to pixel, so that it follows the skin wherever muscles have stretched it. As MikkTSpace
// has it, its axes have length 1 however stretched the texture is, and they are square.

// n: unit, of the front. texel: what the map says, -1..1: along u, against v, along n.
vec3 embossed(vec3 n, vec3 world, vec2 at, vec3 texel) {
  vec3 px = dFdx(world), py = dFdy(world);
  vec2 ax = dFdx(at), ay = dFdy(at);
  float area = ax.x * ay.y - ax.y * ay.x;
  // Texture coordinates that lie on a line or in a point have no directions.
  if (!(area * area > 1e-10 * dot(ax, ax) * dot(ay, ay))) return n;
  vec3 alongU = (px * ay.y - py * ax.y) * sign(area);
  vec3 alongV = (py * ax.x - px * ay.x) * sign(area);
  vec3 t = alongU - n * dot(n, alongU);
  float size = dot(t, t);
  if (!(size > 0.0)) return n;
  t *= inversesqrt(size);
  vec3 b = cross(n, t);
  b *= dot(b, alongV) > 0.0 ? -1.0 : 1.0;  // Mirrored halves of a texture, too.
  vec3 turned = t * texel.x + b * texel.y + n * texel.z;
  float length2 = dot(turned, turned);
  return length2 > 0.0 ? turned * inversesqrt(length2) : n;
}
