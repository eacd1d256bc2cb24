// The functions behind throw and catch: the Itanium C++ ABI ("Exception handling", level II) as
// clang lowers it for WebAssembly. Debian's libc++abi for wasm32-wasi lacks them. They support one
// thread, exceptions of C++ only, and no std::exception_ptr.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <typeinfo>

// The tag of C++ exceptions, whose value is the address of an Exception.
asm(".globl __cpp_exception\n"
    ".tagtype __cpp_exception i32\n"
    "__cpp_exception:\n");

namespace __cxxabiv1 {

/// The base of every std::type_info of libc++abi, with the same virtual functions (its
/// private_typeinfo.h).
class __shim_type_info : public std::type_info {
  public:
    ~__shim_type_info() override;
    virtual void noop1() const;
    virtual void noop2() const;
    /// True if a handler of this type catches an exception of type `thrown`. Moves `object` to the
    /// base class that the handler wants.
    virtual bool can_catch(const __shim_type_info* thrown, void*& object) const = 0;
};

} // namespace __cxxabiv1

namespace {

using TypeInfo = __cxxabiv1::__shim_type_info;

/// The header before each thrown object.
struct alignas(16) Exception {
    const TypeInfo* type;
    void* (*destructor)(void*); ///< null: none. Destructors return their object on this machine
    Exception* caught_before;
    int handlers;   ///< handlers at work; negative: it was rethrown out of that many
    void* adjusted; ///< the object as the handler sees it
};

void* object_of(Exception* exception) {
    return exception + 1;
}
Exception* exception_of(void* object) {
    return static_cast<Exception*>(object) - 1;
}

Exception* caught = nullptr; ///< the exception of the innermost handler at work

/// Memory for a std::bad_alloc when the heap has none.
alignas(Exception) std::byte reserve[sizeof(Exception) + 64];
bool reserve_used = false;

[[noreturn]] void throw_it(Exception* exception) {
    __builtin_wasm_throw(0, exception); // 0 is the tag of C++ exceptions
}

void destroy(Exception* exception) {
    if (exception->destructor != nullptr) exception->destructor(object_of(exception));
    if (exception == static_cast<void*>(&reserve))
        reserve_used = false;
    else
        std::free(exception);
}

/// Reads a compiled table of handlers (numbers of variable length as in DWARF).
class Reader {
  public:
    explicit Reader(const std::uint8_t* at) : at_(at) {}

    std::uint8_t byte() { return *at_++; }
    std::uint32_t number() { return static_cast<std::uint32_t>(bits(false)); }
    std::int32_t signed_number() { return static_cast<std::int32_t>(bits(true)); }
    const std::uint8_t* place() const { return at_; }

  private:
    std::uint64_t bits(bool with_sign) {
        std::uint64_t value = 0;
        unsigned shift = 0;
        std::uint8_t one = 0;
        do {
            one = byte();
            value |= std::uint64_t{one & 0x7FU} << shift;
            shift += 7;
        } while ((one & 0x80U) != 0);
        if (with_sign && (one & 0x40U) != 0 && shift < 64) value |= ~std::uint64_t{0} << shift;
        return value;
    }

    const std::uint8_t* at_;
};

constexpr std::uint8_t omitted = 0xFF; // DW_EH_PE_omit

/// The handler table of a function: the types that its landing pads catch.
struct HandlerTable {
    const std::uint8_t* types_end = nullptr; ///< the i-th type stands i pointers before it
    const std::uint8_t* sites = nullptr;
    const std::uint8_t* actions = nullptr;

    explicit HandlerTable(const std::uint8_t* language_data) {
        Reader reader{language_data};
        if (reader.byte() != omitted)
            std::abort(); // the base of landing pads: none, since they are numbers
        if (reader.byte() != omitted) {
            const std::uint32_t length = reader.number();
            types_end = reader.place() + length;
        }
        reader.byte(); // the encoding of sites: always numbers of variable length
        const std::uint32_t length = reader.number();
        sites = reader.place();
        actions = sites + length;
    }

    /// A type by its number; null: the handler catches everything.
    const TypeInfo* type(std::int32_t index) const {
        return reinterpret_cast<const TypeInfo* const*>(types_end)[-index];
    }

    /// The first action of a landing pad; null if it has none.
    const std::uint8_t* first_action(std::uint32_t pad) const {
        Reader reader{sites};
        for (;; --pad) {
            reader.number(); // skips the pad's own number
            const std::uint32_t action = reader.number();
            if (pad == 0) return action == 0 ? nullptr : actions + (action - 1);
        }
    }
};

/// The number of the type by which a landing pad catches an exception; 0 if it does not.
std::int32_t find_handler(const HandlerTable& table, std::uint32_t pad, Exception& exception) {
    for (const std::uint8_t* action = table.first_action(pad); action != nullptr;) {
        Reader reader{action};
        const std::int32_t index = reader.signed_number();
        const std::uint8_t* const next = reader.place();
        const std::int32_t way = reader.signed_number();
        if (index > 0) {
            const TypeInfo* const type = table.type(index);
            void* object = object_of(&exception);
            if (type == nullptr || type->can_catch(exception.type, object)) {
                exception.adjusted = object;
                return index;
            }
        }
        action = way == 0 ? nullptr : next + way;
    }
    return 0;
}

} // namespace

extern "C" {

/// The landing pad's data, read and written by compiled code.
struct LandingPad {
    std::uint32_t index;
    const std::uint8_t* language_data;
    std::int32_t selector;
};
LandingPad __wasm_lpad_context = {};

int _Unwind_CallPersonality(void* exception) {
    LandingPad& pad = __wasm_lpad_context;
    pad.selector = find_handler(HandlerTable{pad.language_data}, pad.index,
                                *static_cast<Exception*>(exception));
    return 0;
}

void* __cxa_allocate_exception(std::size_t size) noexcept {
    void* memory = std::malloc(sizeof(Exception) + size);
    if (memory == nullptr && !reserve_used && sizeof(Exception) + size <= sizeof reserve) {
        reserve_used = true;
        memory = &reserve;
    }
    if (memory == nullptr) std::terminate();
    auto* const exception = static_cast<Exception*>(memory);
    *exception = {};
    return object_of(exception);
}

void __cxa_free_exception(void* object) noexcept {
    Exception* const exception = exception_of(object);
    exception->destructor = nullptr; // its constructor threw, so there is no object
    destroy(exception);
}

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destructor)(void*)) {
    Exception* const exception = exception_of(object);
    exception->type = static_cast<const TypeInfo*>(type);
    exception->destructor = destructor;
    exception->adjusted = object;
    throw_it(exception);
}

void* __cxa_get_exception_ptr(void* thrown) noexcept {
    return static_cast<Exception*>(thrown)->adjusted;
}

void* __cxa_begin_catch(void* thrown) noexcept {
    auto* const exception = static_cast<Exception*>(thrown);
    exception->handlers = std::abs(exception->handlers) + 1;
    if (exception != caught) {
        exception->caught_before = caught;
        caught = exception;
    }
    return exception->adjusted;
}

void __cxa_end_catch() noexcept {
    Exception* const exception = caught;
    if (exception == nullptr) return;
    const bool thrown_again = exception->handlers < 0;
    exception->handlers += thrown_again ? 1 : -1;
    if (exception->handlers != 0) return;
    caught = exception->caught_before;
    if (!thrown_again) destroy(exception);
}

[[noreturn]] void __cxa_rethrow() {
    if (caught == nullptr) std::terminate();
    caught->handlers = -caught->handlers;
    throw_it(caught);
}

} // extern "C"
