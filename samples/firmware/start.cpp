// From reset to main(): what a C library would do, and no more. The four functions that compilers call by
// themselves are as small as they can be; those of newlib take 600 bytes more.
#include <cstddef>
#include <cstdint>

extern "C" {

extern std::uint32_t data_begin[], data_end[], data_in_flash[];
extern std::uint32_t bss_begin[], bss_end[];
extern void (*const init_array_begin[])();
extern void (*const init_array_end[])();
extern std::uint32_t stack_top[];

int main();

// Every object that lives as long as the program would register its end here; nothing here ends.
int __aeabi_atexit(void*, void (*)(void*), void*) {
    return 0;
}
void* __dso_handle = nullptr;

void* memcpy(void* to, const void* from, std::size_t size) {
    auto* target = static_cast<std::uint8_t*>(to);
    const auto* source = static_cast<const std::uint8_t*>(from);
    while (size-- != 0) {
        *target++ = *source++;
    }
    return to;
}

void* memmove(void* to, const void* from, std::size_t size) {
    auto* target = static_cast<std::uint8_t*>(to);
    const auto* source = static_cast<const std::uint8_t*>(from);
    if (target <= source) {
        return memcpy(to, from, size);
    }
    while (size-- != 0) {
        target[size] = source[size];
    }
    return to;
}

void* memset(void* to, int value, std::size_t size) {
    auto* target = static_cast<std::uint8_t*>(to);
    while (size-- != 0) {
        *target++ = static_cast<std::uint8_t>(value);
    }
    return to;
}

int memcmp(const void* a, const void* b, std::size_t size) {
    const auto* one = static_cast<const std::uint8_t*>(a);
    const auto* other = static_cast<const std::uint8_t*>(b);
    for (; size != 0; --size, ++one, ++other) {
        if (*one != *other) {
            return *one - *other;
        }
    }
    return 0;
}

void reset() {
    const std::uint32_t* from = data_in_flash;
    for (std::uint32_t* to = data_begin; to != data_end;) {
        *to++ = *from++;
    }
    for (std::uint32_t* to = bss_begin; to != bss_end;) {
        *to++ = 0;
    }
    for (void (*const* constructor)() = init_array_begin; constructor != init_array_end; ++constructor) {
        (*constructor)();
    }
    main();
    while (true) {
    }
}

// Any fault ends here; QEMU is told by its time limit, a firmware would reset.
void halt() {
    while (true) {
    }
}

__attribute__((section(".vectors"), used)) void* const vectors[16] = {
    static_cast<void*>(stack_top), reinterpret_cast<void*>(reset), reinterpret_cast<void*>(halt),
    reinterpret_cast<void*>(halt), reinterpret_cast<void*>(halt),  reinterpret_cast<void*>(halt),
    reinterpret_cast<void*>(halt)};

}  // extern "C"
