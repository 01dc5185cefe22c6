// shaders/line.glsl: a segment as a strip of a given width in pixels. Corner 0..5: two triangles. Needs frame.glsl.
out float acrossPixels;
flat out float halfWidth;

// Lifted a little towards the eye, so that lines on a surface stay on top of it.
vec4 lifted(vec3 world) { return clipFromWorld * vec4(world + toEye(world) * 0.0015 * picture.z, 1.0); }

void placeCorner(vec4 a, vec4 b, float width, int corner) {
  const float nearest = 1e-4;
  if (a.w < nearest && b.w < nearest) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  if (a.w < nearest) a = mix(b, a, (b.w - nearest) / (b.w - a.w));
  if (b.w < nearest) b = mix(a, b, (a.w - nearest) / (a.w - b.w));
  vec2 pa = a.xy / a.w * 0.5 * picture.xy, pb = b.xy / b.w * 0.5 * picture.xy;
  vec2 along = pb - pa;
  along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
  halfWidth = 0.5 * width;
  float side = corner % 2 == 0 ? -1.0 : 1.0;
  vec4 end = (corner == 0 || corner == 1 || corner == 3) ? a : b;
  acrossPixels = side * (halfWidth + 1.0);
  end.xy += vec2(-along.y, along.x) * acrossPixels * 2.0 / picture.xy * end.w;
  gl_Position = end;
}
