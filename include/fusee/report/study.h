#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "fusee/study/store.h"
#include "fusee/study/study.h"

namespace fusee::report {

/// The most designs on a study's page; the first ones are shown and the page says so.
inline constexpr std::size_t kMostStudyRows = 20'000;

/// One page that opens offline: a table to sort and filter, with the outlines of both cams and a link to each design's report, and a
/// scatter plot of any two figures with its Pareto front. @throws core::IoError
void write_study_page(const std::filesystem::path& file, const study::Study& study, const std::vector<study::Column>& columns,
                      const study::EachRow& rows);

}  // namespace fusee::report
