#pragma once
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <filesystem>
#include <functional>
#include <string>

namespace fusee::exchange {

/// Sets the product's number and name: OpenCASCADE numbers its products.
void name_product(const Handle(StepBasic_Product) & product, const std::string& name);

/// Runs `fill`, which transfers shapes and sets names, and writes the file: AP242, without time and system in its header, with the
/// provenance as its description. All in one session. @throws core::IoError, also for exceptions of OpenCASCADE
void write_step_model(const std::filesystem::path& path, const std::string& name, const std::string& provenance,
                      const std::function<void(STEPControl_Writer&)>& fill);

/// One shape. @throws core::IoError
void transfer(STEPControl_Writer& writer, const TopoDS_Shape& shape, const std::filesystem::path& path);

}  // namespace fusee::exchange
