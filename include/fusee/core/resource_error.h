#pragma once
#include <string>

#include "fusee/core/error.h"

namespace fusee::core {

/// The machine or a limit of the user ends the work, and no value is wrong: a full disk, a quota, too many open files. Memory, threads and
/// processor time are std::bad_alloc, std::system_error and Stopped. The app ends with exit code 2 and the verdict "out of resources".
class ResourceError : public IoError {
public:
    using IoError::IoError;
};

/// Does this errno say that the machine lacks something: space, quota, memory, threads, open files?
[[nodiscard]] bool is_lack(int error);

/// Of a file or folder that the system does not write. @param error errno
/// @throws ResourceError if the machine lacks something, else IoError: another folder may do
[[noreturn]] void refuse_write(const std::string& path, int error);

}  // namespace fusee::core
