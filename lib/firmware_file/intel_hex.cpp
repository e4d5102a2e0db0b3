#include "firmware_file/intel_hex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "diagnostic/rules/firmware.hpp"

namespace cgw::firmware_file {
namespace {

namespace rules = diagnostic::rules;

constexpr std::size_t prefix = 1;   // ":"
constexpr std::size_t around = 5;   // bytes of a record beside its data: length, address, type, checksum
constexpr std::size_t data_at = 4;  // their place in the record
constexpr std::uint64_t bank = 1U << 16U;
constexpr std::uint64_t segmented_limit = 1U << 20U;

enum Type : std::uint8_t {
    data = 0,
    end_of_file = 1,
    extended_segment = 2,
    start_segment = 3,
    extended_linear = 4,
    start_linear = 5,
};
constexpr std::array<std::size_t, 6> data_sizes{0, 0, 2, 4, 2, 4};  // by type; records of type 00 have any

std::uint8_t sum_of(std::span<const std::uint8_t> bytes) {
    return static_cast<std::uint8_t>(std::accumulate(bytes.begin(), bytes.end(), 0U));
}

std::uint32_t big_endian(std::span<const std::uint8_t> bytes) {
    return std::accumulate(bytes.begin(), bytes.end(), 0U,
                           [](std::uint32_t value, std::uint8_t byte) { return (value << 8U) | byte; });
}

class Reader {
  public:
    Outcome<IntelHex> read(std::span<const std::uint8_t> text) {
        Lines lines(text);
        Line line;
        while (lines.next(line)) {
            if (ended_ && line.is_dos_end()) {
                continue;
            }
            if (ended_) {
                return refuse(rules::record_end, "something follows the end record", line.whole());
            }
            if (Outcome<void> taken = take(line); !taken) {
                return tl::unexpected(taken.error());
            }
        }
        if (!ended_) {
            return refuse(rules::record_end,
                          "the file ends without an end record (:00000001FF): it is not whole",
                          {{lines.count(), 1}, {lines.count(), 1}});
        }
        Outcome<Memory> memory = pieces_.join();
        if (!memory) {
            return tl::unexpected(memory.error());
        }
        file_.memory = std::move(*memory);
        file_.style.line_end = line_end_of(text);
        if (pieces_.longest() != 0) {
            file_.style.data_bytes = pieces_.longest();
        }
        return file_;
    }

  private:
    static Outcome<void> check(const Line& line, const base::Bytes& record) {
        if (record.size() < around || record.size() != around + record[0]) {
            return refuse(
                rules::record_line,
                record.size() < around
                    ? fmt::format("a record has at least {} bytes, this has {}", around, record.size())
                    : fmt::format("the record says it has {} data bytes, and has {}", record[0],
                                  record.size() - around),
                line.whole());
        }
        const std::size_t last = record.size() - 1;
        const auto wanted = static_cast<std::uint8_t>(-sum_of(std::span(record).first(last)));
        if (record[last] != wanted) {
            return refuse(rules::record_checksum,
                          fmt::format("the checksum is {:02X}, the bytes give {:02X}", record[last], wanted),
                          line.range(prefix, last, last + 1));
        }
        const std::uint8_t type = record[3];
        if (type >= data_sizes.size()) {
            return refuse(rules::record_line, fmt::format("there are no records of type {:02X}", type),
                          line.range(prefix, 3, 4));
        }
        if (type != data && record[0] != data_sizes[type]) {
            return refuse(rules::record_line,
                          fmt::format("a record of type {:02X} has {} data bytes, this has {}", type,
                                      data_sizes[type], record[0]),
                          line.range(prefix, 0, 1));
        }
        return {};
    }

    Outcome<void> take(const Line& line) {
        if (line.text.front() != ':') {
            return refuse(rules::record_line, "a record begins with ':'", line.whole());
        }
        const Outcome<base::Bytes> record = decode(line, prefix);
        if (!record) {
            return tl::unexpected(record.error());
        }
        if (Outcome<void> checked = check(line, *record); !checked) {
            return checked;
        }
        const auto address = static_cast<std::uint16_t>(big_endian(std::span(*record).subspan(1, 2)));
        const std::span<const std::uint8_t> bytes = std::span(*record).subspan(data_at, (*record)[0]);
        switch ((*record)[3]) {
            case data:
                return take_data(line, address, bytes);
            case end_of_file:
                ended_ = true;
                file_.end_address = address;
                return {};
            case extended_segment:
            case extended_linear:
                file_.segmented = (*record)[3] == extended_segment;
                base_ = std::uint64_t{big_endian(bytes)} << (file_.segmented ? 4U : 16U);
                return {};
            case start_segment:
                return take_start(line, file_.start_segment, {big_endian(bytes), address});
            default:
                return take_start(line, file_.start_linear, {big_endian(bytes), address});
        }
    }

    Outcome<void> take_data(const Line& line, std::uint32_t offset, std::span<const std::uint8_t> bytes) {
        if (offset + bytes.size() > bank) {
            return refuse(rules::record_address, "the record runs over the end of its 64 KiB",
                          line.range(prefix, 1, 3));
        }
        pieces_.add(base_ + offset, bytes, line);
        return {};
    }

    static Outcome<void> take_start(const Line& line, std::optional<StartRecord>& start,
                                    const StartRecord& read) {
        if (start) {
            return refuse(rules::record_line, "this is a second start address", line.whole());
        }
        start = read;
        return {};
    }

    IntelHex file_;
    Pieces pieces_;
    std::uint64_t base_ = 0;
    bool ended_ = false;
};

class Writer {
  public:
    explicit Writer(const IntelHex& file) : file_(file) {
        const std::vector<Block>& blocks = file.memory.blocks();
        segmented_ = file.segmented && (blocks.empty() || blocks.back().end() <= segmented_limit);
        most_ = settled_size(blocks, file.style.data_bytes, bank);
    }

    std::string take() {
        for (const Block& block : file_.memory.blocks()) {
            write(block);
        }
        write_start(start_segment, file_.start_segment);
        write_start(start_linear, file_.start_linear);
        record(end_of_file, file_.end_address, {});
        return std::move(text_);
    }

  private:
    void write(const Block& block) {
        std::uint64_t address = block.address;
        for (std::span<const std::uint8_t> rest = block.bytes; !rest.empty();) {
            if (address / bank != bank_) {
                open_bank(address / bank);
            }
            const auto size =
                std::min<std::uint64_t>({up_to_multiple(address, most_), rest.size(), bank - address % bank});
            record(data, static_cast<std::uint16_t>(address % bank), rest.first(size));
            rest = rest.subspan(size);
            address += size;
        }
    }

    void open_bank(std::uint64_t number) {
        bank_ = number;
        const std::uint64_t value = segmented_ ? number << 12U : number;
        record(segmented_ ? extended_segment : extended_linear, 0,
               std::array{static_cast<std::uint8_t>(value >> 8U), static_cast<std::uint8_t>(value)});
    }

    void write_start(Type type, const std::optional<StartRecord>& start) {
        if (start) {
            const std::uint32_t value = start->start;
            record(
                type, start->address,
                std::array{static_cast<std::uint8_t>(value >> 24U), static_cast<std::uint8_t>(value >> 16U),
                           static_cast<std::uint8_t>(value >> 8U), static_cast<std::uint8_t>(value)});
        }
    }

    void record(Type type, std::uint16_t address, std::span<const std::uint8_t> bytes) {
        base::Bytes line{static_cast<std::uint8_t>(bytes.size()), static_cast<std::uint8_t>(address >> 8U),
                         static_cast<std::uint8_t>(address), type};
        line.insert(line.end(), bytes.begin(), bytes.end());
        line.push_back(static_cast<std::uint8_t>(-sum_of(line)));
        text_ += ':';
        encode(text_, line);
        text_ += file_.style.line_end;
    }

    const IntelHex& file_;
    bool segmented_ = false;
    std::size_t most_ = 0;  // data bytes of a record
    std::uint64_t bank_ = 0;
    std::string text_;
};

}  // namespace

Outcome<IntelHex> read_intel_hex(std::span<const std::uint8_t> text) {
    return Reader().read(text);
}

std::string write_intel_hex(const IntelHex& file) {
    return Writer(file).take();
}

std::vector<std::string> other_intel_hex_records(std::span<const std::uint8_t> text) {
    constexpr std::size_t type_at = 7;
    std::vector<std::string> records;
    Lines lines(text);
    Line line;
    while (lines.next(line)) {
        const std::string_view type = line.text.substr(std::min(type_at, line.text.size()), 2);
        if (type == "01" || type == "03" || type == "05") {
            records.push_back(line.upper_case());
        }
    }
    std::sort(records.begin(), records.end());
    return records;
}

}  // namespace cgw::firmware_file
