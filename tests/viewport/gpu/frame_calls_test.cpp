// tests/viewport/gpu/frame_calls_test.cpp: OpenGL calls of a GPU frame: no allocation, no wait, no driver message.
#include <string>
#include <vector>

#include "tests/viewport/gpu/on_card.h"

namespace sinew::test {
namespace {

/// While alive, counts calls that allocate memory on the GPU or wait for it, by replacing the driver's functions.
class CountedCalls {
 public:
  CountedCalls() {
    now_ = this;
    real_ = {
        epoxy_glNamedBufferData, epoxy_glNamedBufferStorage, epoxy_glCreateBuffers,      epoxy_glGetNamedBufferSubData,
        epoxy_glFinish,          epoxy_glClientWaitSync,     epoxy_glGetQueryObjectui64v};
    epoxy_glNamedBufferData = [](GLuint buffer, GLsizeiptr size, const void* data, GLenum usage) {
      ++now_->allocations;
      now_->real_.bufferData(buffer, size, data, usage);
    };
    epoxy_glNamedBufferStorage = [](GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
      ++now_->allocations;
      now_->real_.bufferStorage(buffer, size, data, flags);
    };
    epoxy_glCreateBuffers = [](GLsizei count, GLuint* buffers) {
      ++now_->allocations;
      now_->real_.createBuffers(count, buffers);
    };
    epoxy_glGetNamedBufferSubData = [](GLuint buffer, GLintptr offset, GLsizeiptr size, void* data) {
      ++now_->waits;
      now_->real_.getSubData(buffer, offset, size, data);
    };
    epoxy_glFinish = [] {
      ++now_->waits;
      now_->real_.finish();
    };
    epoxy_glClientWaitSync = [](GLsync sync, GLbitfield flags, GLuint64 timeout) {
      ++now_->waits;
      return now_->real_.waitSync(sync, flags, timeout);
    };
    epoxy_glGetQueryObjectui64v = [](GLuint query, GLenum name, GLuint64* value) {
      ++now_->waits;
      now_->real_.queryResult(query, name, value);
    };
  }
  ~CountedCalls() {
    epoxy_glNamedBufferData = real_.bufferData;
    epoxy_glNamedBufferStorage = real_.bufferStorage;
    epoxy_glCreateBuffers = real_.createBuffers;
    epoxy_glGetNamedBufferSubData = real_.getSubData;
    epoxy_glFinish = real_.finish;
    epoxy_glClientWaitSync = real_.waitSync;
    epoxy_glGetQueryObjectui64v = real_.queryResult;
  }
  CountedCalls(const CountedCalls&) = delete;
  CountedCalls& operator=(const CountedCalls&) = delete;

  int allocations = 0;
  int waits = 0;

 private:
  struct Functions {
    decltype(epoxy_glNamedBufferData) bufferData;
    decltype(epoxy_glNamedBufferStorage) bufferStorage;
    decltype(epoxy_glCreateBuffers) createBuffers;
    decltype(epoxy_glGetNamedBufferSubData) getSubData;
    decltype(epoxy_glFinish) finish;
    decltype(epoxy_glClientWaitSync) waitSync;
    decltype(epoxy_glGetQueryObjectui64v) queryResult;
  };
  static inline CountedCalls* now_ = nullptr;
  Functions real_{};
};

/// Driver messages about errors and performance.
struct Complaints {
  std::vector<std::string> texts;
  int heard = 0;  ///< Of any kind.

  Complaints() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(
        [](GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* self) {
          auto& complaints = *static_cast<Complaints*>(const_cast<void*>(self));
          ++complaints.heard;
          if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_PERFORMANCE ||
              type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) {
            complaints.texts.emplace_back(text);
          }
        },
        this);
  }
  ~Complaints() {
    glDebugMessageCallback(nullptr, nullptr);
    glDisable(GL_DEBUG_OUTPUT);
  }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;
};

class FrameCalls : public OnCard {};

TEST_F(FrameCalls, NeverAllocateOrWait) {
  for (const char* name : {"humanoid-flex", "wrapped"}) {
    const TrialScene scene = bundledTrialScene(name);
    app::CardSurface card = surfaceFor(prepared(scene.character, scene.rig));
    const std::vector<Pose> poses = spreadPoses(*scene.character, 12);
    ASSERT_FALSE(card.setPose(poses.front()).has_value());
    card.make();
    (void)readDrawn(card);  // By now all functions have been called once and are resolved to the driver's.
    (void)card.seconds();
    glFinish();
    Complaints complaints;
    {
      CountedCalls calls;
      for (const Pose& pose : poses) {
        ASSERT_FALSE(card.setPose(pose).has_value());
        card.make();
      }
      EXPECT_EQ(calls.allocations, 0) << name;
      EXPECT_EQ(calls.waits, 0) << name;
      (void)readDrawn(card);
      EXPECT_GT(calls.waits, 0) << "reading back is counted";
      (void)surfaceFor(prepared(scene.character, scene.rig));
      EXPECT_GT(calls.allocations, 10) << "so is a new surface";
    }
    EXPECT_TRUE(complaints.texts.empty()) << name << ": " << complaints.texts.front();
    const char* const planted = "planted";
    glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_PERFORMANCE, 1, GL_DEBUG_SEVERITY_HIGH, -1,
                         planted);
    ASSERT_EQ(complaints.texts.size(), 1u) << "complaints are heard";
    EXPECT_EQ(complaints.texts.front(), planted);
  }
}

}  // namespace
}  // namespace sinew::test
