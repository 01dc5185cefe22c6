// app/viewport/render/gl_objects.cpp: creates OpenGL objects; loads shaders.
#include "app/viewport/render/gl_objects.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "app/ui/data_files.h"

namespace sinew::app {
namespace {

Result<std::string> readShader(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    return Error{file.string(), "",
                 "cannot be read; the installation may be incomplete (SINEW_DATA_DIR sets the data folder)"};
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// Formulas that shaders share with the processor are in core, other included files in the folder of shaders.
std::filesystem::path includedFile(const std::string& name) {
  return name.starts_with("core/") ? dataFile(name) : dataFile(std::filesystem::path("shaders") / name);
}

/// Replaces `#include "name"` lines, one level deep, and inserts the defines below the version line (the first).
/// #line keeps the line numbers of the file.
Result<std::string> expand(const std::string& source, const std::vector<const char*>& define) {
  constexpr std::string_view kInclude = "#include \"";
  std::string out;
  int line = 0;
  for (std::size_t at = 0; at < source.size();) {
    const std::size_t end = std::min(source.find('\n', at), source.size());
    const std::string_view text = std::string_view(source).substr(at, end - at);
    at = end + 1;
    ++line;
    if (!text.starts_with(kInclude)) {
      out.append(text).append("\n");
      if (line > 1) continue;
      for (const char* name : define) out.append("#define ").append(name).append(" 1\n");
      out.append("#line 2\n");
      continue;
    }
    const std::string_view rest = text.substr(kInclude.size());
    const std::string name(rest.substr(0, rest.find('"')));
    const Result<std::string> included = readShader(includedFile(name));
    if (!included) return included.error();
    out.append(included.value()).append("\n#line ").append(std::to_string(line + 1)).append("\n");
  }
  return out;
}

GLenum stageOf(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".vert") return GL_VERTEX_SHADER;
  if (ending == ".geom") return GL_GEOMETRY_SHADER;
  if (ending == ".comp") return GL_COMPUTE_SHADER;
  assert(ending == ".frag");
  return GL_FRAGMENT_SHADER;
}

std::string firstLine(const std::string& log) { return log.substr(0, log.find_first_of("\n\r")); }

Result<GlShader> compileShader(const char* name, const std::vector<const char*>& define) {
  const std::filesystem::path file = dataFile(name);
  const Result<std::string> raw = readShader(file);
  if (!raw) return raw.error();
  const Result<std::string> source = expand(raw.value(), define);
  if (!source) return source.error();
  GlShader shader(glCreateShader(stageOf(file)));
  const char* text = source->c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return Error{file.string(), "", "the graphics driver refuses this shader: " + firstLine(log)};
}

}  // namespace

GlBuffer makeBuffer() {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  return GlBuffer(id);
}

GlVertexArray makeVertexArray() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  return GlVertexArray(id);
}

GlTexture makeTexture(GLenum target) {
  GLuint id = 0;
  glCreateTextures(target, 1, &id);
  return GlTexture(id);
}

GlRenderbuffer makeRenderbuffer() {
  GLuint id = 0;
  glCreateRenderbuffers(1, &id);
  return GlRenderbuffer(id);
}

GlFramebuffer makeFramebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  return GlFramebuffer(id);
}

GlQuery makeQuery(GLenum target) {
  GLuint id = 0;
  glCreateQueries(target, 1, &id);
  return GlQuery(id);
}

GlTexture uploadTexture(GLenum format, int width, int height, const std::vector<std::uint8_t>& rgba, bool mipmaps) {
  GlTexture texture = makeTexture(GL_TEXTURE_2D);
  const GLuint id = texture.id();
  const int levels = mipmaps ? std::bit_width(static_cast<unsigned>(std::max(width, height))) : 1;
  glTextureStorage2D(id, levels, format, width, height);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  if (mipmaps) glGenerateTextureMipmap(id);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

void setAttribute(GLuint array, GLuint location, GLuint binding, GLint count, std::size_t offset) {
  glEnableVertexArrayAttrib(array, location);
  glVertexArrayAttribFormat(array, location, count, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(array, location, binding);
}

Result<GlProgram> GlProgram::load(const std::vector<const char*>& files, const std::vector<const char*>& define) {
  GlProgram program;
  program.program_ = GlObject<GlProgramTraits>(glCreateProgram());
  std::vector<GlShader> shaders;
  for (const char* file : files) {
    Result<GlShader> shader = compileShader(file, define);
    if (!shader) return shader.error();
    glAttachShader(program.id(), shader->id());
    shaders.push_back(std::move(shader).value());
  }
  glLinkProgram(program.id());
  for (const GlShader& shader : shaders) glDetachShader(program.id(), shader.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(program.id(), static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return Error{dataFile(files.front()).string(), "", "the graphics driver cannot link this shader: " + firstLine(log)};
}

void GlProgram::set(const char* name, int value) const { glProgramUniform1i(id(), location(name), value); }
void GlProgram::set(const char* name, float value) const { glProgramUniform1f(id(), location(name), value); }
void GlProgram::set(const char* name, const glm::vec2& value) const {
  glProgramUniform2fv(id(), location(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const glm::vec3& value) const {
  glProgramUniform3fv(id(), location(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const glm::vec4& value) const {
  glProgramUniform4fv(id(), location(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void GlProgram::set(const char* name, std::span<const glm::vec4> values) const {
  if (values.empty()) return;
  glProgramUniform4fv(id(), location(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}

Result<void> loadPrograms(std::initializer_list<ProgramFiles> all) {
  for (const ProgramFiles& one : all) {
    Result<GlProgram> program = GlProgram::load(one.files, one.define);
    if (!program) return program.error();
    one.program = std::move(program).value();
  }
  return {};
}

std::string rendererName() {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name == nullptr ? std::string("unknown") : std::string(reinterpret_cast<const char*>(name));
}

bool isSoftwareRenderer() {
  const std::string name = rendererName();
  return name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos ||
         name.find("SwiftShader") != std::string::npos;
}

// Framebuffers and their means.

void RenderTarget::resize(const glm::ivec2& size, int samples) {
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const int wanted = std::clamp(samples, 1, std::max(most, 1));
  if (size == size_ && wanted == samples_) return;
  size_ = size;
  samples_ = wanted;

  color_ = makeTexture(GL_TEXTURE_2D);
  glTextureStorage2D(color_.id(), 1, GL_SRGB8_ALPHA8, size.x, size.y);
  GLuint view = 0;
  glGenTextures(1, &view);
  shown_ = GlTexture(view);
  glTextureView(view, GL_TEXTURE_2D, color_.id(), GL_RGBA8, 0, 1, 0, 1);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTextureParameteri(view, filter, GL_LINEAR);
  }
  depth_.reset();
  many_.reset();
  manyColor_.reset();
  manyDepth_.reset();
  resolved_ = makeFramebuffer();
  glNamedFramebufferTexture(resolved_.id(), GL_COLOR_ATTACHMENT0, color_.id(), 0);
  if (samples_ == 1) {
    depth_ = makeRenderbuffer();
    glNamedRenderbufferStorage(depth_.id(), GL_DEPTH_COMPONENT32F, size.x, size.y);
    glNamedFramebufferRenderbuffer(resolved_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    return;
  }
  manyColor_ = makeRenderbuffer();
  manyDepth_ = makeRenderbuffer();
  many_ = makeFramebuffer();
  glNamedRenderbufferStorageMultisample(manyColor_.id(), samples_, GL_SRGB8_ALPHA8, size.x, size.y);
  glNamedRenderbufferStorageMultisample(manyDepth_.id(), samples_, GL_DEPTH_COMPONENT32F, size.x, size.y);
  glNamedFramebufferRenderbuffer(many_.id(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, manyColor_.id());
  glNamedFramebufferRenderbuffer(many_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, manyDepth_.id());
}

void RenderTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, samples_ == 1 ? resolved_.id() : many_.id());
  glViewport(0, 0, size_.x, size_.y);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_FRAMEBUFFER_SRGB);
}

void RenderTarget::end() const {
  if (samples_ == 1) return;
  glBlitNamedFramebuffer(many_.id(), resolved_.id(), 0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

PictureMean::PictureMean() : empty_(makeVertexArray()) {}

Result<PictureMean> PictureMean::create() {
  PictureMean mean;
  Result<GlProgram> program = GlProgram::load({"shaders/fullscreen.vert", "shaders/copy.frag"});
  if (!program) return program.error();
  mean.copyProgram_ = std::move(program).value();
  return mean;
}

void PictureMean::begin(const glm::ivec2& size) {
  count_ = 0;
  if (size == size_) return;
  size_ = size;
  sum_ = makeTexture(GL_TEXTURE_2D);
  glTextureStorage2D(sum_.id(), 1, GL_RGBA32F, size.x, size.y);
  sumTarget_ = makeFramebuffer();
  glNamedFramebufferTexture(sumTarget_.id(), GL_COLOR_ATTACHMENT0, sum_.id(), 0);
}

void PictureMean::copy(GLuint source, GLuint framebuffer, float factor) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size_.x, size_.y);
  glBindTextureUnit(0, source);
  copyProgram_.use();
  copyProgram_.set("source", 0);
  copyProgram_.set("factor", factor);
  glBindVertexArray(empty_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void PictureMean::add(const RenderTarget& picture) {
  glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_DEPTH_TEST);
  if (count_ > 0) {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
  } else {
    glDisable(GL_BLEND);
  }
  copy(picture.linearTexture(), sumTarget_.id(), 1.0f);
  glDisable(GL_BLEND);
  ++count_;
}

void PictureMean::writeTo(const RenderTarget& target) const {
  glEnable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  copy(sum_.id(), target.framebuffer(), 1.0f / static_cast<float>(count_));
  glDisable(GL_FRAMEBUFFER_SRGB);
}

glm::vec2 sampleOffset(int index) {
  // The first two dimensions of Sobol's sequence.
  glm::vec2 at(0.5f / static_cast<float>(kMeanSamples));
  for (int bits = index, x = kMeanSamples / 2, y = kMeanSamples / 2, sum = 0; bits != 0; bits >>= 1, x >>= 1) {
    if ((bits & 1) != 0) {
      at.x += static_cast<float>(x) / static_cast<float>(kMeanSamples);
      sum ^= y;
      at.y = (0.5f + static_cast<float>(sum)) / static_cast<float>(kMeanSamples);
    }
    y ^= y >> 1;
  }
  return at - 0.5f;
}

}  // namespace sinew::app
