#pragma once
// The part of GDNative, Godot 3's interface for C, that this host uses. Debian has no header of it, so that
// the functions stand here by their places in the interface's table, which is the same in all of Godot 3.

#include <cstddef>
#include <cstdint>

namespace gdnative {

struct Object;
/// A value of any type, an array of vectors, and the right to write to one.
struct alignas(8) Variant {
    std::byte hidden[24];
};
struct alignas(8) Array {
    std::byte hidden[8];
};
struct WriteAccess;

struct Extension {
    unsigned type, major, minor;
    const Extension* next;
};
constexpr unsigned type_of_nativescript = 1;

/// The interface, a table of functions.
struct Core {
    unsigned type, major, minor;
    const Extension* next;
    unsigned extension_count;
    const Extension* const* extensions;
    void (*functions[541])();
};

struct InitOptions {
    bool in_editor;
    std::uint64_t core_hash, editor_hash, no_hash;
    void (*report_version_mismatch)();
    void (*report_loading_error)();
    Object* library;
    const Core* core;
};

/// The function at a place of the table.
template <class Function>
Function* function(const Core& core, std::size_t place) {
    return reinterpret_cast<Function*>(core.functions[place]);
}

/// An array's functions: godot_pool_int_array_..., godot_pool_vector3_array_...
struct ArrayFunctions {
    ArrayFunctions(const Core& core, std::size_t first, std::size_t first_of_access, std::size_t to_variant)
        : make(function<void(Array*)>(core, first)),
          resize(function<void(Array*, int)>(core, first + 9)),
          write(function<WriteAccess*(Array*)>(core, first + 11)),
          destroy(function<void(Array*)>(core, first + 15)),
          data(function<void*(const WriteAccess*)>(core, first_of_access + 1)),
          end_write(function<void(WriteAccess*)>(core, first_of_access + 3)),
          variant(function<void(Variant*, const Array*)>(core, to_variant)) {}
    void (*make)(Array*);
    void (*resize)(Array*, int);
    WriteAccess* (*write)(Array*);
    void (*destroy)(Array*);
    void* (*data)(const WriteAccess*);
    void (*end_write)(WriteAccess*);
    void (*variant)(Variant*, const Array*);
};

/// The functions that this host calls.
struct Functions {
    explicit Functions(const Core& core)
        : ints(core, 171, 299, 531),
          vectors(core, 235, 315, 535),
          new_nil(function<void(Variant*)>(core, 509)),
          as_int(function<std::int64_t(const Variant*)>(core, 539)),
          as_real(function<double(const Variant*)>(core, 540)) {}
    ArrayFunctions ints, vectors;
    void (*new_nil)(Variant*);
    std::int64_t (*as_int)(const Variant*);
    double (*as_real)(const Variant*);
};

struct Create {
    void* (*call)(Object*, void*);
    void* data;
    void (*free)(void*);
};
struct Destroy {
    void (*call)(Object*, void*, void*);
    void* data;
    void (*free)(void*);
};
struct Method {
    Variant (*call)(Object*, void* data, void* instance, int count, Variant** arguments);
    void* data;
    void (*free)(void*);
};
struct MethodAttributes {
    std::int32_t rpc_mode;
};

/// The extension that registers classes.
struct NativeScript {
    Extension head;
    void (*register_class)(void* handle, const char* name, const char* base, Create, Destroy);
    void (*register_tool_class)(void* handle, const char* name, const char* base, Create, Destroy);
    void (*register_method)(void* handle, const char* name, const char* method, MethodAttributes, Method);
};

}  // namespace gdnative
