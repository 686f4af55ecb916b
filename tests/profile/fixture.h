#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/profile/profile.h"

namespace fusee::profile {

/// A folder for one test, and profiles that differ from a short valid one by one edit.
class ProfileTest : public ::testing::Test {
protected:
    void SetUp() override {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(::testing::TempDir()) / ("fusee_profile_" + std::to_string(::getpid()) + "_" + info->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// The valid profile with `from` replaced by `to`.
    static std::string edited(const std::string& from, const std::string& to) {
        std::string text = kShort;
        const auto at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    }
    Profile read(const std::string& toml) const {
        core::write_file(folder_ / "p.toml", toml);
        return read_profile(folder_ / "p.toml");
    }
    /// What the refusal says; "" if there is none.
    std::string refusal(const std::string& toml) const {
        try {
            (void)read(toml);
        } catch (const core::InputError& e) {
            return e.what();
        }
        return "";
    }

    static constexpr const char* kShort =
        "name = \"short\"\n"                                                                     // line 1
        "[rig]\n"                                                                                // 2
        "capstan_radius_mm = 30\njoint_radius_mm = 25\ngear_friction = 0.28\n"                   // 3-5
        "least_torque_Nm = 0.78\npeak_torque_Nm = 1.0\noverdrive_torque_Nm = 1.5\n"              // 6-8
        "[law]\n"                                                                                // 9
        "kind = \"stiction_compensating\"\nk_per_Nm_rad = 0.225\nu_Nm = 0.0012\nc_Nm = 0.265\n"  // 10-13
        "start_torque_Nm = 0.6\nend_torque_Nm = 2.09\nlead_in_deg = 5\n"                         // 14-16
        "[cable]\ndiameter_mm = 0.8\n"                                                           // 17-18
        "[process]\nkind = \"fdm\"\n"                                                            // 19-20
        "[k_se.spring]\nrate_Nm_per_rad = 0.0183\npreload_rad = 3.6\n"                           // 21-23
        "[k_pe.spring]\nrate_N_per_m = 7460\npreload_mm = 14.6\n";                               // 24-26
    std::filesystem::path folder_;
};

/// Every word is in the text.
inline void expect_words(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << '\'' << word << "' in: " << text;
}

}  // namespace fusee::profile
