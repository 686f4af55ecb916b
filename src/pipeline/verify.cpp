#include "fusee/pipeline/verify.h"

#include "fusee/core/temporary_folder.h"

namespace fusee::pipeline {

MakeResult make_to_verify(const profile::Profile& profile) {
    const core::TemporaryFolder folder;
    MakeResult result = make(profile, {.out = folder.path()});
    result.folder.clear();
    return result;
}

}  // namespace fusee::pipeline
