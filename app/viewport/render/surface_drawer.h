// app/viewport/render/surface_drawer.h: streams and draws the smoothed surface.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/viewport/render/card_vertices.h"
#include "app/viewport/render/frame.h"
#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/material_textures.h"
#include "app/viewport/render/seen_triangles.h"
#include "app/viewport/render/shadow_mesh.h"

namespace sinew::app {

// Shaders/surface.frag in its many kinds.

struct SurfaceKind {
  Shading shading = Shading::kTextured;
  bool wired = false;
  bool marked = false;
  bool colored = false;  ///< By the vertices: kTextured alone.
  bool chosen = false;   ///< A light that was chosen, or with occlusion.
  MapSet maps = 0;

  friend auto operator<=>(const SurfaceKind&, const SurfaceKind&) = default;
};

class SurfacePrograms {
 public:
  /// Makes those that are used most; the others are made when first used.
  [[nodiscard]] static Result<SurfacePrograms> create();

  /// Of a kind that cannot be made: without maps, and in the usual light.
  [[nodiscard]] const GlProgram& of(const SurfaceKind& kind) const;

 private:
  mutable std::map<SurfaceKind, GlProgram> made_;  ///< Those that cannot be made own nothing.
};

class SurfaceDrawer {
 public:
  [[nodiscard]] static Result<SurfaceDrawer> create();

  /// Textures with mipmaps, and materials.
  void setCharacter(const Character& character);
  /// As Viewport::setCardVertices.
  void setCardVertices(const std::optional<CardVertices>& vertices) { cardVertices_ = vertices; }
  /// Uploads what has changed: vertices unless the surface is the one of the last call, index buffers when the
  /// refinement or what is culled is another one, skin values with refinement or territory. The scene has a surface.
  /// @param showsClasses  it is drawn in the colors of Shading::kClasses, which are uploaded for that alone
  void upload(const Scene& scene, bool showsClasses);
  /// For the frame's picture, up to the next upload: where the processor draws, opaque triangles that leave no trace
  /// are left out. The picture is the same, with one sample a pixel. The scene is the one of the last upload.
  void leaveOutUnseen(const Frame& frame);

  void drawOpaque(const Frame& frame) const;
  /// The same with a program of the caller's, in use, that takes the attributes of shaders/surface.vert.
  /// Blended where the caller has switched blending on.
  void drawOpaque(const GlProgram& program, const Frame& frame) const;
  /// Materials whose alpha blends: back sides first, then front sides.
  void drawBlended(const Frame& frame) const;
  /// Scene::litParts as a tint over the surface, which has been drawn. A part of which nothing is seen, such as teeth,
  /// shows through what is before it, fainter.
  void drawLitParts(const Frame& frame) const;
  /// All triangles, for shadows: with `solid`, or with `withAlpha` where the picture shows a material's alpha. Where
  /// the processor draws: a ShadowMesh, since a blurred shadow does not show the difference. Culled triangles cast
  /// theirs too.
  void drawForShadow(const Frame& frame, const GlProgram& solid, const GlProgram& withAlpha) const;
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

 private:
  struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    float displacement;
  };
  using Range = ShadowMesh::Range;  ///< Consecutive triangles of the index buffer with one material.
  /// What changes with the character, the depth and the territory alone, as 0..255.
  struct SkinValues {
    std::uint8_t open = 255;
    std::uint8_t territory = 0;
    std::array<std::uint8_t, 2> unused{};
  };
  SurfaceDrawer();
  void rebuildSkinValues(const ControlMesh& mesh);
  void fillVertices(const Scene& scene);
  void stage(const Surface& surface);
  /// Of the array that is bound: of the surface, and of that beside it.
  void drawTriangles(int firstTriangle, int triangles) const;
  void takeCardVertices();
  void fillClasses(const Scene& scene);
  void rebuildTopology(const Character& character);
  /// Control triangles by material, the culled left out: controlOrder_, ranges_ and the indices to draw.
  void rebuildOrder(const ControlMesh& mesh, const GlBuffer& indices, GLenum usage);
  class OwnProgram;
  const GlProgram& prepareProgram(const Frame& frame, MapSet maps) const;
  const Material& materialOf(const Range& range) const;
  /// What the material's alpha does in this picture.
  static AlphaMode alphaIn(const Frame& frame, const Material& material);
  template <class Draw>
  void drawOpaqueRanges(const Frame& frame, const Draw& draw) const;
  void drawRange(const GlProgram& program, const Frame& frame, const Range& range, MapSet maps) const;
  void drawPart(const Frame& frame, const LitPart& lit, float strength) const;

  SurfacePrograms programs_;
  GlProgram partProgram_;
  GlQuery partSeen_;  ///< Whether anything of a part was seen.
  GlVertexArray array_;
  GlBuffer vertices_, besideVertices_, uvs_, skinValues_, colors_, indices_, keptIndices_, seenIndices_, shadowIndices_,
      controlOf_, classes_, parts_;
  MaterialTextures textures_;
  std::vector<Material> materials_;
  std::vector<int> materialOfPart_;  ///< [parts]
  std::shared_ptr<const Refinement> refinement_;
  std::vector<std::uint8_t> culled_;  ///< Surface::culled as in keptIndices_; empty: all is drawn, from indices_.
  std::vector<int> controlOrder_;     ///< Control triangles in the order drawn: by material.
  std::vector<int> refinedOrder_;     ///< Their refined triangles.
  std::vector<Range> ranges_;
  std::vector<std::uint8_t> showsBacks_;  ///< [ranges_] 1: the material is double-sided.
  SeenTriangles seen_;                    ///< In seenIndices_.
  bool drawsSeen_ = false;                ///< Opaque materials are drawn from there.
  std::vector<int> shadowClusters_;
  std::vector<Range>
      shadowRanges_;  ///< Culled ones too; of shadowIndices_ where the processor draws, else of indices_.
  std::vector<Vertex> staging_;
  std::optional<CardVertices> cardVertices_;
  std::vector<float> open_;        ///< [V] how open each control vertex is (occlusion.h).
  std::vector<float> territory_;   ///< [V] or empty, as in skinValues_.
  std::vector<SkinLayer> layers_;  ///< Scene::layers, as in classes_.
  std::uint64_t revision_ = 0;     ///< Scene::surfaceRevision of what is uploaded; 0: unknown.
  bool hasClasses_ = false;        ///< classes_ are those of the last call of upload().
  bool hasBeside_ = false;         ///< besideVertices_ are drawn too.
  Bounds bounds_;                  ///< Of all that is drawn.
};

}  // namespace sinew::app
