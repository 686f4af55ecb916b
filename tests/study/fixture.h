#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/study/study.h"

namespace fusee::study {

/// A folder with studies around the shipped profile.
class StudyFolder : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        core::write_file(folder_.path() / name, text);
        return folder_.path() / name;
    }
    /// @param tail what follows `base` in the table [study]
    Study study(const std::string& tail) const {
        const std::string base = FUSEE_SOURCE_DIR "/profiles/pnrvsa.toml";
        return read_study(write("s.toml", "[study]\nbase = \"" + base + "\"\n" + tail));
    }
    core::TemporaryFolder folder_;
};

}  // namespace fusee::study
