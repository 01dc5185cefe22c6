// app/viewport/render/surface_drawer.h: uploads and draws the smoothed surface.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/viewport/render/fewer_triangles.h"
#include "app/viewport/render/frame.h"
#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/material_textures.h"
#include "app/viewport/render/scene.h"

namespace sinew::app {

/// A variant of shaders/surface.frag.
struct SurfaceKind {
  Shading shading = Shading::kTextured;
  bool wired = false;
  bool marked = false;
  bool colored = false;  ///< By vertex; kTextured only.
  bool chosen = false;   ///< Another light than the studio, or occlusion.
  MapSet maps = 0;

  friend auto operator<=>(const SurfaceKind&, const SurfaceKind&) = default;
};

class SurfacePrograms {
 public:
  [[nodiscard]] static Result<SurfacePrograms> create();  ///< Loads the common kinds; others are loaded on first use.

  /// A kind that fails to load is replaced by the one without maps and in the usual light.
  [[nodiscard]] const GlProgram& of(const SurfaceKind& kind) const;

 private:
  mutable std::map<SurfaceKind, GlProgram> made_;  ///< Empty where loading failed.
};

class SurfaceDrawer {
 public:
  [[nodiscard]] static Result<SurfaceDrawer> create();

  void setCharacter(const Character& character);  ///< Textures with mipmaps, and materials.
  /// As Viewport::setCardVertices.
  void setCardVertices(const std::optional<CardVertices>& vertices) { cardVertices_ = vertices; }
  /// Uploads what has changed: vertices by surfaceRevision, index buffers by refinement, skin values by
  /// refinement and territory. The scene has a surface. @param showsClasses  with the colors of Shading::kClasses
  void upload(const Scene& scene, bool showsClasses);
  /// Until the next upload: where the processor draws, leaves out opaque triangles that cover no pixel. Pictures with
  /// one sample per pixel do not change. The scene is that of the last upload.
  void leaveOutUnseen(const Frame& frame);

  void drawOpaque(const Frame& frame) const;
  /// With a program that is in use and takes the attributes of shaders/surface.vert. Blended if blending is enabled.
  void drawOpaque(const GlProgram& program, const Frame& frame) const;
  void drawBlended(const Frame& frame) const;  ///< Materials with alpha blending: back sides, then front sides.
  /// Tints Scene::litParts on the drawn surface. A part that is wholly hidden, such as teeth, shines through, fainter.
  void drawLitParts(const Frame& frame) const;
  /// All triangles: with `withAlpha` where the picture shows a material's alpha, else with
  /// `solid`. Where the processor draws: a ShadowMesh.
  void drawForShadow(const Frame& frame, const GlProgram& solid, const GlProgram& withAlpha) const;
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

 private:
  struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    float displacement;
  };
  using Range = ShadowMesh::Range;  ///< Part of the index buffer.
  /// Attributes that do not change with the pose.
  struct SkinValues {
    std::uint8_t open = 255;
    std::uint8_t territory = 0;
    std::array<std::uint8_t, 2> unused{};
  };
  SurfaceDrawer();
  void rebuildSkinValues(const ControlMesh& mesh);
  void fillVertices(const Scene& scene);
  void stage(const Surface& surface);
  void drawTriangles(int firstTriangle, int triangles) const;  ///< Draws from the bound array, and the second surface.
  void takeCardVertices();
  void fillClasses(const Scene& scene);
  void rebuildTopology(const Character& character);
  /// Sorts control triangles by material: controlOrder_, ranges_ and the indices.
  void rebuildOrder(const ControlMesh& mesh);
  class OwnProgram;
  const GlProgram& prepareProgram(const Frame& frame, MapSet maps) const;
  const Material& materialOf(const Range& range) const;
  static AlphaMode alphaIn(const Frame& frame, const Material& material);
  template <class Draw>
  void drawOpaqueRanges(const Frame& frame, const Draw& draw) const;
  void drawRange(const GlProgram& program, const Frame& frame, const Range& range, MapSet maps) const;
  void drawPart(const Frame& frame, const LitPart& lit, float strength) const;

  SurfacePrograms programs_;
  GlProgram partProgram_;
  GlQuery partSeen_;  ///< Whether a part is visible.
  GlVertexArray array_;
  GlBuffer vertices_, besideVertices_, uvs_, skinValues_, colors_, indices_, seenIndices_, shadowIndices_, controlOf_,
      classes_, parts_;
  MaterialTextures textures_;
  std::vector<Material> materials_;
  std::vector<int> materialOfPart_;  ///< [parts]
  std::shared_ptr<const Refinement> refinement_;
  std::vector<int> controlOrder_;  ///< Control triangles by material.
  std::vector<int> refinedOrder_;  ///< Their refined triangles.
  std::vector<Range> ranges_;
  std::vector<std::uint8_t> showsBacks_;  ///< [ranges_] 1: the material is double-sided.
  SeenTriangles seen_;                    ///< In seenIndices_.
  bool drawsSeen_ = false;                ///< Opaque materials are drawn from there.
  std::vector<int> shadowClusters_;
  std::vector<Range> shadowRanges_;  ///< Parts of shadowIndices_ where the processor draws, else of indices_.
  std::vector<Vertex> staging_;
  std::optional<CardVertices> cardVertices_;
  std::vector<float> open_;        ///< [V] how open each control vertex is (occlusion.h).
  std::vector<float> territory_;   ///< [V] or empty, as in skinValues_.
  std::vector<SkinLayer> layers_;  ///< Scene::layers, as in classes_.
  std::uint64_t revision_ = 0;     ///< Uploaded Scene::surfaceRevision; 0: unknown.
  bool hasClasses_ = false;        ///< classes_ belong to the last upload().
  bool hasBeside_ = false;         ///< besideVertices_ are drawn.
  Bounds bounds_;                  ///< Everything drawn.
};

}  // namespace sinew::app
