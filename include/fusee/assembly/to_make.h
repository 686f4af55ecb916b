#pragma once
#include <vector>

#include "fusee/assembly/assembly.h"
#include "fusee/checks/limits.h"
#include "fusee/drawing/body_sheet.h"

/// What of a joint a shop has to make.
namespace fusee::assembly {

/// The bodies beside the cams that the workshop makes, in the assembly's order. The pointers are into `assembly`.
[[nodiscard]] std::vector<const Body*> bodies_to_make(const Assembly& assembly);
/// Of such a body: the frame's plate is a sheet of aluminium, since a printed one would give way; others are of the parts' material, or
/// that of prints where the parts are cut from sheets.
[[nodiscard]] checks::Material material_of(const Assembly& assembly, const Body& body);

/// How the bodies beside the cams are made: as the cams, but printed where these are cut from sheets. The frame's plate is a sheet.
[[nodiscard]] checks::Process process_of(const Assembly& assembly);

/// The mesh of such a body to print: turned by quarter turns to where it needs least support.
[[nodiscard]] solid::Mesh mesh_on_bed(const Assembly& assembly, const Body& body);

/// A body of the frame with what its sheet shows.
struct FrameSheet {
    const Body* body;
    drawing::SheetBody drawn;
};
/// Of both brackets, tower and posts: their holes have to fit bought parts. Nothing without a frame. They refer to `assembly`.
[[nodiscard]] std::vector<FrameSheet> frame_sheets(const Assembly& assembly);

}  // namespace fusee::assembly
