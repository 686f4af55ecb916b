#include "made_parts.h"

#include "fusee/core/folder.h"

namespace fusee::app {

core::Outcome<pipeline::MadeDesign> made_parts(profile::Profile profile) {
    profile.outputs.formats = {"stl"};
    const core::TemporaryFolder folder;
    core::OutputFolder output(folder.path() / "parts", {.command = "make", .source = profile.file});  // never committed
    return pipeline::make_parts(profile, output);
}

}  // namespace fusee::app
