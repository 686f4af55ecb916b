#pragma once
#include <vector>

#include "fusee/assembly/assembly.h"
#include "fusee/checks/limits.h"
#include "fusee/drawing/body_sheet.h"

/// What of a joint a shop has to make.
namespace fusee::assembly {

/// The bodies beside the cams that the workshop makes, in the assembly's order. The pointers are into `assembly`.
[[nodiscard]] std::vector<const Body*> bodies_to_make(const Assembly& assembly);
/// How such a body is made: the frame's plate is milled of aluminium, since a printed one would give way; others are made as the cams, or
/// printed where these are cut from sheets.
[[nodiscard]] checks::Process process_of(const Assembly& assembly, const Body& body);
[[nodiscard]] checks::Material material_of(const Assembly& assembly, const Body& body);

/// The mesh of such a body to print: turned by quarter turns to where it needs least support.
[[nodiscard]] solid::Mesh mesh_on_bed(const Assembly& assembly, const Body& body);

/// What the sheet of such a body shows. It refers to `assembly`.
[[nodiscard]] drawing::SheetBody sheet_of(const Assembly& assembly, const Body& body);

}  // namespace fusee::assembly
