#pragma once
#include <Model/COM/NMR_DLLInterfaces.h>

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/solid/mesh.h"

/// The C interface of lib3mf with ownership and errors, for the files of this module that write and read 3MF.
namespace fusee::exchange {

/// lib3mf is not documented as thread-safe: one thread at a time uses it.
[[nodiscard]] std::mutex& library_mutex();

/// An object of lib3mf, released at the end of its scope. In the C interface, handles of all kinds are void**.
class Handle {
public:
    Handle() = default;
    ~Handle() {
        if (object_ != nullptr) NMR::lib3mf_release(object_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    [[nodiscard]] NMR::PLib3MFBase* get() const { return object_; }
    [[nodiscard]] NMR::PLib3MFBase** out() { return &object_; }

private:
    NMR::PLib3MFBase* object_ = nullptr;
};

/// @throws IoError with the message that lib3mf gives for the object of the call
void require(LIB3MFRESULT result, const Handle& object, const std::filesystem::path& path, const char* doing);

/// Makes an empty model in millimetres; from bytes, that of a 3MF file. @throws IoError
void make_model(Handle& model, const std::filesystem::path& path);
void read_model(Handle& model, std::string bytes, const std::filesystem::path& path);

/// Calls `use` with each build item and its object.
void for_each_item(const Handle& model, const std::filesystem::path& path,
                   const std::function<void(const Handle& item, const Handle& object)>& use);

/// An RFC 9562 version 8 UUID made from a hash: the same input names the same object.
[[nodiscard]] std::string uuid_from(std::string_view text);

/// Text that is valid in XML 1.0: U+FFFD replaces control characters and bytes that are not UTF-8.
[[nodiscard]] std::string xml_text(std::string_view text);

/// Sets the object's name. lib3mf escapes it.
void set_name(const Handle& object, const std::string& name, const std::filesystem::path& path);
/// The object's name; "" if it has none.
[[nodiscard]] std::string name_of(const Handle& object, const std::filesystem::path& path);
/// Sets the model's metadata "Description", escaped: lib3mf writes metadata without escaping.
void set_description(const Handle& model, const std::string& text, const std::filesystem::path& path);

/// The model as the bytes of a 3MF file. @throws IoError
[[nodiscard]] std::string bytes_of(const Handle& model, const std::filesystem::path& path);

/// Sets points, in single precision, and triangles of a mesh object. @returns lib3mf's result
[[nodiscard]] LIB3MFRESULT set_geometry(const Handle& object, const std::vector<solid::Vec3>& points_mm,
                                        const std::vector<solid::Triangle>& triangles);
/// Points and triangles of a mesh object, in the unit of the model. @throws IoError, also if there are no triangles
[[nodiscard]] solid::Mesh take_mesh(const Handle& object, const std::filesystem::path& path);

}  // namespace fusee::exchange
