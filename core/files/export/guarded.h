// core/files/export/guarded.h: what an export throws inside, as the error that it returns.
#pragma once

#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "core/files/fit/stage_progress.h"
#include "core/files/gltf/file.h"
#include "sinew/geometry/result.h"

namespace sinew::exporting {

/// @param file  that is written  @param make  () -> Result<Report>
template <class Make>
[[nodiscard]] auto catchErrors(const std::filesystem::path& characterFile, const std::filesystem::path& file,
                               const Make& make) -> decltype(make()) {
  try {
    return make();
  } catch (const gltf::Refusal& refusal) {
    return Error{characterFile.string(), refusal.error.place, refusal.error.reason};
  } catch (const Canceled&) {
    return Error{file.string(), {}, std::string(kCanceled)};
  } catch (const std::bad_alloc&) {
    return Error{characterFile.string(), {}, "there is not enough memory to export it"};
  } catch (const std::exception& error) {
    return Error{characterFile.string(), {}, shortened(error.what())};
  }
}

}  // namespace sinew::exporting
