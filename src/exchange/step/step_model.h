#pragma once
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>

class STEPControl_Reader;
class TopoDS_Shape;

namespace fusee::exchange {

/// Sets the product's number and name: OpenCASCADE numbers its products.
void name_product(const Handle(StepBasic_Product) & product, const std::string& name);

/// Runs `fill`, which transfers shapes and sets names, and writes the file: AP242, without time and system in its header, with the
/// provenance as its description. All in one session. @throws core::IoError, also for exceptions of OpenCASCADE
void write_step_model(const std::filesystem::path& path, const std::string& name, const std::string& provenance,
                      const std::function<void(STEPControl_Writer&)>& fill);

/// One shape. @throws core::IoError
void transfer(STEPControl_Writer& writer, const TopoDS_Shape& shape, const std::filesystem::path& path);

/// STEP in OpenCASCADE has global settings: one reader or writer at a time. The first call initializes it and turns its messages off.
[[nodiscard]] std::mutex& step_session();

/// Reads a STEP file with OpenCASCADE after require_sound_step and passes its shape, in millimetres, to `take`, all in one session.
/// @param bytes of the file
/// @throws core::IoError naming the file, also for exceptions of OpenCASCADE in `take`; std::bad_alloc
void with_step_shape(const std::filesystem::path& path, const std::string& bytes,
                     const std::function<void(const TopoDS_Shape&, STEPControl_Reader&)>& take);

}  // namespace fusee::exchange
