#pragma once
#include <filesystem>
#include <functional>
#include <string>

class STEPControl_Reader;
class TopoDS_Shape;

namespace fusee::exchange {

/// Reads a STEP file with OpenCASCADE after require_sound_step and passes its shape, in millimetres, to `take`, all in one session.
/// @param bytes of the file
/// @throws core::IoError naming the file, also for exceptions of OpenCASCADE in `take`; std::bad_alloc
void with_step_shape(const std::filesystem::path& path, const std::string& bytes,
                     const std::function<void(const TopoDS_Shape&, STEPControl_Reader&)>& take);

}  // namespace fusee::exchange
