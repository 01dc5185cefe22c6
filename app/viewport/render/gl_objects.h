// app/viewport/render/gl_objects.h: owners of OpenGL objects. Create and destroy them with a current context.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "sinew/geometry/geometry.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// Owner of one OpenGL name; 0: none.
template <class Traits>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint id) : id_(id) {}
  ~GlObject() { reset(); }
  GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    if (this != &other) {
      reset();
      id_ = std::exchange(other.id_, 0);
    }
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;

  [[nodiscard]] GLuint id() const { return id_; }
  [[nodiscard]] explicit operator bool() const { return id_ != 0; }
  void reset() {
    if (id_ != 0) Traits::destroy(id_);
    id_ = 0;
  }

 private:
  GLuint id_ = 0;
};

struct GlBufferTraits {
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct GlVertexArrayTraits {
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct GlTextureTraits {
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct GlRenderbufferTraits {
  static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};
struct GlFramebufferTraits {
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct GlShaderTraits {
  static void destroy(GLuint id) { glDeleteShader(id); }
};
struct GlQueryTraits {
  static void destroy(GLuint id) { glDeleteQueries(1, &id); }
};
struct GlProgramTraits {
  static void destroy(GLuint id) { glDeleteProgram(id); }
};

using GlBuffer = GlObject<GlBufferTraits>;
using GlVertexArray = GlObject<GlVertexArrayTraits>;
using GlTexture = GlObject<GlTextureTraits>;
using GlRenderbuffer = GlObject<GlRenderbufferTraits>;
using GlFramebuffer = GlObject<GlFramebufferTraits>;
using GlQuery = GlObject<GlQueryTraits>;
using GlShader = GlObject<GlShaderTraits>;

[[nodiscard]] GlBuffer makeBuffer();
[[nodiscard]] GlVertexArray makeVertexArray();
[[nodiscard]] GlTexture makeTexture(GLenum target);
[[nodiscard]] GlRenderbuffer makeRenderbuffer();
[[nodiscard]] GlFramebuffer makeFramebuffer();
[[nodiscard]] GlQuery makeQuery(GLenum target);

/// RGBA pixels in 8 bits as a texture with linear filters, repeated. @param mipmaps  all levels; else one
[[nodiscard]] GlTexture uploadTexture(GLenum format, int width, int height, const std::vector<std::uint8_t>& rgba,
                                      bool mipmaps);

/// Enables an attribute of `count` floats at an offset in the binding.
void setAttribute(GLuint array, GLuint location, GLuint binding, GLint count, std::size_t offset);

/// Replaces a buffer's bytes without waiting for a frame in flight.
template <class T>
void uploadBuffer(const GlBuffer& buffer, std::span<const T> values, GLenum usage = GL_STREAM_DRAW) {
  const auto bytes = static_cast<GLsizeiptr>(values.size_bytes());
  glNamedBufferData(buffer.id(), bytes > 0 ? bytes : 4, bytes > 0 ? values.data() : nullptr, usage);
}

/// A linked shader program. Uniforms that the linker removed are skipped.
class GlProgram {
 public:
  GlProgram() = default;
  /// @param files  data files: "shaders/x.vert", ".geom", ".frag", or one ".comp"; a line `#include "y.glsl"` inserts
  /// shaders/y.glsl. @param define  names defined as 1 in all of them. Error: the file and the driver's first message.
  [[nodiscard]] static Result<GlProgram> load(const std::vector<const char*>& files,
                                              const std::vector<const char*>& define = {});

  void use() const { glUseProgram(program_.id()); }
  [[nodiscard]] GLuint id() const { return program_.id(); }
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, const glm::vec2& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, const glm::vec4& value) const;
  void set(const char* name, const glm::mat4& value) const;
  void set(const char* name, std::span<const glm::vec4> values) const;

 private:
  [[nodiscard]] GLint location(const char* name) const { return glGetUniformLocation(program_.id(), name); }
  GlObject<GlProgramTraits> program_;
};

struct ProgramFiles {
  GlProgram& program;
  std::vector<const char*> files;
  std::vector<const char*> define{};
};
/// GlProgram::load for each. Error: the first that fails.
[[nodiscard]] Result<void> loadPrograms(std::initializer_list<ProgramFiles> all);

[[nodiscard]] std::string rendererName();  ///< For example "llvmpipe (LLVM 15.0.6, 256 bits)".
[[nodiscard]] bool isSoftwareRenderer();   ///< Whether the processor draws.

// The picture's framebuffer, and means of pictures.

class RenderTarget {
 public:
  void resize(const glm::ivec2& size, int samples);  ///< Size >= 1x1; samples >= 1, clamped to the driver's maximum.
  void begin() const;  ///< Binds framebuffer and viewport; colors are linear and stored as sRGB.
  void end() const;    ///< Averages the samples into the texture.

  [[nodiscard]] const glm::ivec2& size() const { return size_; }
  /// The finished picture, read without decoding sRGB.
  [[nodiscard]] GLuint texture() const { return shown_.id(); }
  [[nodiscard]] GLuint framebuffer() const { return resolved_.id(); }
  /// The same texture read as linear light.
  [[nodiscard]] GLuint linearTexture() const { return color_.id(); }

 private:
  glm::ivec2 size_{0};
  int samples_ = 0;
  GlTexture color_;
  GlTexture shown_;  ///< The same memory, not decoded.
  GlRenderbuffer depth_, manyColor_, manyDepth_;
  GlFramebuffer resolved_, many_;
};

/// Mean of pictures of one scene, each shifted by a fraction of a pixel.
class PictureMean {
 public:
  [[nodiscard]] static Result<PictureMean> create();

  void begin(const glm::ivec2& size);
  void add(const RenderTarget& picture);
  void writeTo(const RenderTarget& target) const;  ///< Writes the mean of >= 1 pictures to a target of the same size.
  [[nodiscard]] int count() const { return count_; }

 private:
  PictureMean();
  void copy(GLuint source, GLuint framebuffer, float factor) const;

  GlProgram copyProgram_;
  GlVertexArray empty_;
  glm::ivec2 size_{0};
  int count_ = 0;
  GlTexture sum_;
  GlFramebuffer sumTarget_;
};

inline constexpr int kMeanSamples = 16;
inline constexpr int kFewSamples = 4;  ///< After which the mean is first shown.
/// kFewSamples or kMeanSamples, at least `samples` if possible.
[[nodiscard]] constexpr int meanSamples(int samples) { return samples <= kFewSamples ? kFewSamples : kMeanSamples; }
/// Offset of a sample in pixels, -0.5..0.5. Any 4 or 16 in a row from a multiple of 4 spread evenly over the pixel.
[[nodiscard]] glm::vec2 sampleOffset(int index);

}  // namespace sinew::app
