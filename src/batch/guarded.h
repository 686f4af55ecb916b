#pragma once
#include <new>
#include <system_error>

#include "fusee/batch/batch.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/core/resource_error.h"

namespace fusee::batch {

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
