#include "firmware_file/s_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include "diagnostic/rules/firmware.hpp"

namespace cgw::firmware_file {
namespace {

namespace rules = diagnostic::rules;

constexpr std::size_t prefix = 2;     // "S1"
constexpr std::size_t longest = 255;  // bytes that the length can tell: address, data, checksum

enum class Role { header, data, reserved, count, end };

// By the digit behind the S.
struct Type {
    Role role;
    std::size_t address_bytes;
};
constexpr std::array<Type, 10> types{{{Role::header, 2},
                                      {Role::data, 2},
                                      {Role::data, 3},
                                      {Role::data, 4},
                                      {Role::reserved, 0},
                                      {Role::count, 2},
                                      {Role::count, 3},
                                      {Role::end, 4},
                                      {Role::end, 3},
                                      {Role::end, 2}}};

std::uint8_t checksum(std::span<const std::uint8_t> bytes) {
    return static_cast<std::uint8_t>(~std::accumulate(bytes.begin(), bytes.end(), 0U));
}

class Reader {
  public:
    Outcome<SRecord> read(std::span<const std::uint8_t> text) {
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
                          "the file ends without an end record (S7, S8 or S9): it is not whole",
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
    static Outcome<void> check(const Line& line, const Type& type, const base::Bytes& record) {
        if (record.empty() || record.size() != 1U + record[0]) {
            return refuse(rules::record_line,
                          record.empty() ? "the record has no length"
                                         : fmt::format("the record says that {} bytes follow, and has {}",
                                                       record[0], record.size() - 1),
                          line.whole());
        }
        if (record[0] < type.address_bytes + 1) {
            return refuse(rules::record_line, "the record is too short for its address and checksum",
                          line.whole());
        }
        const std::size_t last = record.size() - 1;
        const std::uint8_t wanted = checksum(std::span(record).first(last));
        if (record[last] != wanted) {
            return refuse(rules::record_checksum,
                          fmt::format("the checksum is {:02X}, the bytes give {:02X}", record[last], wanted),
                          line.range(prefix, last, last + 1));
        }
        return {};
    }

    Outcome<void> take(const Line& line) {
        const std::string_view text = line.text;
        if (text.size() < prefix || text[0] != 'S' || text[1] < '0' || text[1] > '9') {
            return refuse(rules::record_line, "a record begins with S0 to S9", line.whole());
        }
        const Type type = types[static_cast<std::size_t>(text[1] - '0')];
        if (type.role == Role::reserved) {
            return refuse(rules::record_line, "there are no S4 records",
                          {{line.number, 1}, {line.number, 3}});
        }
        const Outcome<base::Bytes> record = decode(line, prefix);
        if (!record) {
            return tl::unexpected(record.error());
        }
        if (Outcome<void> checked = check(line, type, *record); !checked) {
            return checked;
        }
        std::uint32_t address = 0;
        for (std::size_t i = 0; i < type.address_bytes; ++i) {
            address = (address << 8U) | (*record)[1 + i];
        }
        return apply(
            line, type, address,
            std::span(*record).subspan(1 + type.address_bytes, (*record)[0] - type.address_bytes - 1));
    }

    Outcome<void> apply(const Line& line, const Type& type, std::uint32_t address,
                        std::span<const std::uint8_t> bytes) {
        if (type.role == Role::data) {
            ++data_records_;
            if (address + bytes.size() > std::uint64_t{1} << (8 * type.address_bytes)) {
                return refuse(rules::record_address, "the record runs over the highest address it can have",
                              line.range(prefix, 1, 1 + type.address_bytes));
            }
            pieces_.add(address, bytes, line);
            file_.address_bytes = std::max(file_.address_bytes, type.address_bytes);
            return {};
        }
        if (type.role == Role::header) {
            file_.headers.push_back(
                {static_cast<std::uint16_t>(address), base::Bytes(bytes.begin(), bytes.end())});
            return {};
        }
        if (!bytes.empty()) {
            return refuse(rules::record_line, "this kind of record has no data", line.whole());
        }
        if (type.role == Role::end) {
            ended_ = true;
            file_.start = address;
            file_.address_bytes = std::max(file_.address_bytes, type.address_bytes);
            return {};
        }
        file_.counted = true;
        if (address != data_records_) {
            return refuse(rules::record_end,
                          fmt::format("this counts {} data records, the file has {}", address, data_records_),
                          line.whole());
        }
        return {};
    }

    SRecord file_;
    Pieces pieces_;
    std::uint32_t data_records_ = 0;
    bool ended_ = false;
};

class Writer {
  public:
    explicit Writer(const SRecord& file) : file_(file), address_bytes_(file.address_bytes) {
        const std::vector<Block>& blocks = file.memory.blocks();
        const std::uint64_t highest =
            std::max<std::uint64_t>(file.start, blocks.empty() ? 0 : blocks.back().end() - 1);
        while (address_bytes_ < 4 && highest >> (8 * address_bytes_) != 0) {
            ++address_bytes_;
        }
        most_ = settled_size(blocks, std::min(file.style.data_bytes, longest - address_bytes_ - 1), 0);
    }

    std::string take() {
        for (const SRecordHeader& header : file_.headers) {
            record('0', 2, header.address, header.bytes);
        }
        for (const Block& block : file_.memory.blocks()) {
            write(block);
        }
        if (file_.counted && records_ < 1U << 24U) {
            const bool small = records_ < 1U << 16U;
            record(small ? '5' : '6', small ? 2 : 3, records_, {});
        }
        record(static_cast<char>('0' + 11 - address_bytes_), address_bytes_, file_.start, {});
        return std::move(text_);
    }

  private:
    void write(const Block& block) {
        std::uint64_t address = block.address;
        for (std::span<const std::uint8_t> rest = block.bytes; !rest.empty();) {
            const std::size_t size = std::min(up_to_multiple(address, most_), rest.size());
            record(static_cast<char>('0' + address_bytes_ - 1), address_bytes_,
                   static_cast<std::uint32_t>(address), rest.first(size));
            ++records_;
            rest = rest.subspan(size);
            address += size;
        }
    }

    void record(char type, std::size_t address_bytes, std::uint32_t address,
                std::span<const std::uint8_t> bytes) {
        base::Bytes line{static_cast<std::uint8_t>(address_bytes + bytes.size() + 1)};
        for (std::size_t i = address_bytes; i > 0; --i) {
            line.push_back(static_cast<std::uint8_t>(address >> (8 * (i - 1))));
        }
        line.insert(line.end(), bytes.begin(), bytes.end());
        line.push_back(checksum(line));
        text_ += 'S';
        text_ += type;
        encode(text_, line);
        text_ += file_.style.line_end;
    }

    const SRecord& file_;
    std::size_t address_bytes_;
    std::size_t most_ = 0;  // data bytes of a record
    std::uint32_t records_ = 0;
    std::string text_;
};

}  // namespace

Outcome<SRecord> read_s_record(std::span<const std::uint8_t> text) {
    return Reader().read(text);
}

std::string write_s_record(const SRecord& file) {
    return Writer(file).take();
}

std::vector<std::string> other_s_records(std::span<const std::uint8_t> text) {
    std::set<std::string> once;
    std::vector<std::string> records;
    Lines lines(text);
    Line line;
    while (lines.next(line)) {
        const std::string record = line.upper_case();
        if (record.starts_with("S0")) {
            records.push_back(record);
        } else if (record.starts_with("S5") || record.starts_with("S6")) {
            once.insert("count");
        } else if (record.starts_with("S7") || record.starts_with("S8") || record.starts_with("S9")) {
            constexpr std::size_t address_at = 4, checksum_size = 2;
            const std::string address = record.substr(address_at, record.size() - address_at - checksum_size);
            once.insert("start " + address.substr(std::min(address.find_first_not_of('0'), address.size())));
        }
    }
    records.insert(records.end(), once.begin(), once.end());
    std::sort(records.begin(), records.end());
    return records;
}

}  // namespace cgw::firmware_file
