// Files and the end of the program by ARM semihosting: for programs that run in an emulator or under a
// debugger. Not for a firmware that ships: without a debugger a call is a fault.
#pragma once

#include <cstddef>
#include <cstdint>

namespace semihosting {

enum Operation : std::uint32_t {
    open_file = 0x01,
    close_file = 0x02,
    write0 = 0x04,
    write_file = 0x05,
    read_file = 0x06,
    exit_extended = 0x20
};
enum Mode : std::uint32_t { read_binary = 1, write_binary = 5 };
inline constexpr std::uint32_t application_exit = 0x20026;
inline constexpr std::uint32_t no_file = 0xFFFF'FFFF;

inline std::uint32_t call(Operation operation, const void* arguments) {
    register std::uint32_t number asm("r0") = operation;
    register const void* block asm("r1") = arguments;
    asm volatile("bkpt 0xAB" : "+r"(number) : "r"(block) : "memory");
    return number;
}

[[noreturn]] inline void exit(std::uint32_t code) {
    const std::uint32_t arguments[] = {application_exit, code};
    call(exit_extended, arguments);
    while (true) {
    }
}

[[noreturn]] inline void fail(const char* reason) {
    call(write0, reason);
    call(write0, "\n");
    exit(1);
}

template <std::size_t length>
std::uint32_t open(const char (&name)[length], Mode mode) {
    const std::uint32_t arguments[] = {reinterpret_cast<std::uint32_t>(&name[0]), mode, length - 1};
    return call(open_file, arguments);  // no_file when it cannot be had
}

inline void close(std::uint32_t handle) {
    call(close_file, &handle);
}

// How many bytes were read; 0 for a file that could not be opened.
inline std::uint32_t read(std::uint32_t handle, void* to, std::uint32_t size) {
    const std::uint32_t arguments[] = {handle, reinterpret_cast<std::uint32_t>(to), size};
    const std::uint32_t missing = call(read_file, arguments);
    return missing <= size ? size - missing : 0;
}
// True when all bytes were written.
inline bool write(std::uint32_t handle, const void* from, std::uint32_t size) {
    const std::uint32_t arguments[] = {handle, reinterpret_cast<std::uint32_t>(from), size};
    return call(write_file, arguments) == 0;
}

}  // namespace semihosting
