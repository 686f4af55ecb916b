#pragma once
#include <filesystem>
#include <functional>
#include <new>
#include <system_error>
#include <vector>

#include "fusee/batch/batch.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/core/resource_error.h"

namespace fusee::batch {

/// Work on the profile that stands at `place` of the list: true if done, false if refused.
using Work = std::function<bool(const profile::Profile& profile, std::size_t place)>;

/// Reads every profile, then works on each on its own, `jobs` at a time (0: one for each processor), and advances `progress`, if any. An
/// exception of `work` becomes its row's outcome. In the profiles' order.
[[nodiscard]] std::vector<Ended> run_each(const std::vector<std::filesystem::path>& profiles, const Work& work, unsigned jobs,
                                          core::Progress* progress);

/// The rows with the outcome of each.
template <class AnyRow>
std::vector<AnyRow> joined(std::vector<AnyRow> rows, const std::vector<Ended>& ended) {
    for (std::size_t i = 0; i < rows.size(); ++i) static_cast<Ended&>(rows[i]) = ended[i];
    return rows;
}

/// Runs `work` and turns what it throws into a row's outcome and error.
template <class Guarded>
void guarded(Ended& row, const Guarded& work) {
    try {
        work();
    } catch (const core::InvalidInput& e) {
        row.outcome = Outcome::kBadInput, row.error = e.what(), row.mistakes = {e};
    } catch (const core::InvalidInputs& e) {
        row.outcome = Outcome::kBadInput, row.error = e.what(), row.mistakes = e.all();
    } catch (const core::ResourceError& e) {
        row.outcome = Outcome::kOutOfResources, row.error = e.what();
    } catch (const core::InputError& e) {
        row.outcome = Outcome::kBadInput, row.error = e.what();
    } catch (const std::bad_alloc&) {
        row.outcome = Outcome::kOutOfResources,
        row.error = "out of memory: more is needed than the machine or its limit (ulimit -v) allows";
    } catch (const std::system_error& e) {  // a full disk, no more threads, a working folder that is gone
        row.outcome = core::is_lack(e.code().value()) ? Outcome::kOutOfResources : Outcome::kBadInput, row.error = e.what();
    } catch (const core::Stopped&) {
        row.outcome = Outcome::kInterrupted;
    } catch (const std::exception& e) {
        row.outcome = Outcome::kFailed, row.error = e.what();
    }
}

}  // namespace fusee::batch
