// On the microcontroller: replays the calls in the file `exchange` and writes what the gateway does about
// them to the file `answers`. Files are the host's, by ARM semihosting.
#include "exchange.hpp"
#include "semihosting.hpp"

extern "C" {
extern const unsigned char cgw_config_image[];
extern const unsigned int cgw_config_image_size;
extern std::uint32_t stack_top[];
}

namespace cgw::exchange {
namespace {

constexpr std::size_t buffer_size = 4096;

class Output final : public Sink {
  public:
    void put(std::span<const std::uint8_t> bytes) override {
        for (const std::uint8_t byte : bytes) {
            if (used_ == buffer_size) {
                flush();
            }
            buffer_[used_++] = byte;
        }
    }
    void flush() {
        if (!semihosting::write(handle_, buffer_.data(), used_)) {
            semihosting::fail("answers cannot be written");
        }
        used_ = 0;
    }

  private:
    std::uint32_t handle_ = semihosting::open("answers", semihosting::write_binary);
    std::array<std::uint8_t, buffer_size> buffer_{};
    std::size_t used_ = 0;
};

class Input {
  public:
    Record next() {
        Record record;
        record.call = static_cast<Call>(u8());
        const std::uint32_t low = u32();
        record.time = low | (Time{u32()} << 32U);
        record.frame.id = u32();
        record.frame.length = u8();
        const std::uint8_t kind = u8();
        record.frame.extended = (kind & 1U) != 0;
        record.frame.remote = (kind & 2U) != 0;
        for (std::uint8_t& byte : record.frame.data) {
            byte = u8();
        }
        record.first = u8();
        record.second = u8();
        record.answers = u8();
        for (unsigned i = 0; i < record.answers; i += 8) {
            record.taken[i / 8] = u8();
        }
        return record;
    }

  private:
    std::uint8_t u8() {
        if (used_ == filled_) {
            filled_ = semihosting::read(handle_, buffer_.data(), buffer_size);
            used_ = 0;
            if (filled_ == 0) {
                semihosting::fail("the exchange has no end");
            }
        }
        return buffer_[used_++];
    }
    std::uint32_t u32() {
        std::uint32_t value = 0;
        for (unsigned shift = 0; shift < 32; shift += 8) {
            value |= std::uint32_t{u8()} << shift;
        }
        return value;
    }

    std::uint32_t handle_ = semihosting::open("exchange", semihosting::read_binary);
    std::array<std::uint8_t, buffer_size> buffer_{};
    std::size_t used_ = 0;
    std::size_t filled_ = 0;
};

// Both ports answer as they did when the exchange was recorded. Whoever sends more than then is refused, and
// will be found out by what it wrote.
class Port final : public frame::FramePort {
  public:
    bool send(const frame::Frame&) override {
        const unsigned answer = given_++;
        return answer < record_->answers && ((record_->taken[answer / 8] >> (answer % 8)) & 1U) != 0;
    }
    void follow(const Record& record) {
        record_ = &record;
        given_ = 0;
    }

  private:
    const Record* record_ = nullptr;
    unsigned given_ = 0;
};

image::Image image_in_flash;
Port port;
Output output;
Input input;
Bench bench(image_in_flash, port, port, output);

constexpr std::uint32_t paint = 0x5AFE'57AC;
constexpr std::size_t painted_words = 8192;

// The stack that is not in use yet, filled so that its use shows.
void paint_stack() {
    std::uint32_t* end = nullptr;
    asm volatile("mov %0, sp" : "=r"(end));
    for (std::uint32_t* word = stack_top - painted_words; word < end; ++word) {
        *word = paint;
    }
}

std::size_t stack_used() {
    const std::uint32_t* word = stack_top - painted_words;
    while (*word == paint) {
        ++word;
    }
    return static_cast<std::size_t>(stack_top - word) * sizeof(std::uint32_t);
}

void say_stack(std::size_t bytes) {
    char text[] = "stack ......\n";
    for (std::size_t i = 11; i > 5; --i, bytes /= 10) {
        text[i] = static_cast<char>('0' + bytes % 10);
    }
    semihosting::call(semihosting::write0, text);
}

[[noreturn]] void replay() {
    paint_stack();
    if (image::Image::open({cgw_config_image, cgw_config_image_size}, image_in_flash) != image::Status::ok) {
        semihosting::fail("the embedded image is refused");
    }
    Record record;
    do {
        record = input.next();
        port.follow(record);
        bench.perform(record);
    } while (record.call != Call::end);
    output.flush();
    say_stack(stack_used());
    semihosting::exit(0);
}

}  // namespace
}  // namespace cgw::exchange

int main() {
    cgw::exchange::replay();
}
