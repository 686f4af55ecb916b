#pragma once
#include <string_view>

namespace fusee::app {

extern const std::string_view kGlossary;        ///< docs/glossary.md
extern const std::string_view kGapCases;        ///< docs/gap.md
extern const std::string_view kBatch;           ///< docs/guides/batch.md
extern const std::string_view kOwnModel;        ///< docs/guides/my-simulator-does-not-match.md
extern const std::string_view kShippedProfile;  ///< profiles/pnrvsa.toml

}  // namespace fusee::app
