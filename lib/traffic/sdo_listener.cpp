#include "traffic/sdo_listener.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/abort_codes.hpp"
#include "base/canopen_text.hpp"
#include "base/utf8.hpp"
#include "dictionary/value_text.hpp"
#include "signals/codec.hpp"
#include "traffic/decoder.hpp"
#include "wire/little_endian.hpp"

namespace cgw::traffic {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t sdo_length = 8;
constexpr std::uint8_t abort_command = 0x80;
constexpr std::uint8_t block_end = 0xA1;  // of the side that receives
constexpr std::uint8_t expedited = 0x02;
constexpr std::uint8_t size_stated = 0x01;
constexpr std::uint8_t last_segment = 0x01;
constexpr std::size_t segment_bytes = 7;
constexpr std::size_t expedited_bytes = 4;

// Command specifiers, the upper three bits; requests and answers count for themselves.
enum Request : std::uint8_t {
    download_segment = 0,
    initiate_download = 1,
    initiate_upload = 2,
    upload_segment = 3,
    block_upload = 5,
    block_download = 6,
};
enum Answer : std::uint8_t {
    upload_segment_answer = 0,
    download_segment_answer = 1,
    upload_answer = 2,
    download_answer = 3,
    block_download_answer = 5,
    block_upload_answer = 6,
};

std::string hexadecimal(Bytes bytes, std::size_t count) {
    return bytes_text(bytes) + (count > bytes.size() ? fmt::format(" … ({} bytes)", count) : "");
}

std::string abort_message(Bytes data) {
    return base::abort_text(wire::load_u32(data.data() + 4));
}

}  // namespace

std::string SdoListener::object_text(std::uint8_t node, std::uint16_t index, std::uint8_t sub_index) const {
    constexpr std::uint16_t first_of_device = 0x2000;  // below it names are those of CiA 301, for every node
    std::string text = base::object_text(index, sub_index);
    const bool known = node == subject_->node_id || index < first_of_device;
    if (subject_->dictionary == nullptr || !known) {
        return text;
    }
    const dictionary::Object* const object = subject_->dictionary->find(index);
    const dictionary::Variable* const variable = object != nullptr ? object->find(sub_index) : nullptr;
    if (variable == nullptr) {
        return text;
    }
    const bool has_subs = object::has_sub_objects(object->code);
    return fmt::format("{} {}", text, has_subs ? variable->name : object->name);
}

std::string SdoListener::value_text(std::uint8_t node, const Transfer& transfer) const {
    const std::size_t kept = std::min(transfer.count, transfer.kept.size());
    const Bytes bytes = Bytes(transfer.kept).first(kept);
    if (node != subject_->node_id) {
        return hexadecimal(bytes, transfer.count);
    }
    for (const signals::Frame& frame : subject_->frames) {
        for (signals::Signal signal : frame.signals) {
            if (!signal.is_bit() && signal.index == transfer.index &&
                signal.sub_index == transfer.sub_index && transfer.count == 2) {
                signal.first_bit = 0;
                return signals::value_text(signal, signals::raw_value(signal, bytes));
            }
        }
    }
    const dictionary::Variable* const variable =
        subject_->dictionary != nullptr ? subject_->dictionary->find(transfer.index, transfer.sub_index)
                                        : nullptr;
    if (variable == nullptr || object::size_of(variable->type) == 0 ||
        object::size_of(variable->type) != transfer.count) {
        return hexadecimal(bytes, transfer.count);
    }
    dictionary::Value value;
    for (std::size_t i = 0; i < kept; ++i) {
        value.number |= std::uint64_t{bytes[i]} << 8 * i;
    }
    return dictionary::value_text(variable->type, value);
}

void SdoListener::begin(std::uint8_t node, Mode mode, Bytes data) {
    transfers_[node] = {
        .mode = mode, .index = wire::load_u16(data.data() + 1), .sub_index = data[3], .kept = {}, .count = 0};
}

void SdoListener::keep_expedited(Transfer& transfer, Bytes data) const {
    const std::size_t unused = (data[0] & size_stated) != 0 ? data[0] >> 2 & 3U : 0;
    transfer.count = expedited_bytes - unused;
    std::copy_n(data.begin() + 4, transfer.count, transfer.kept.begin());
}

std::string SdoListener::listen(std::uint8_t node, bool request, Bytes data) {
    node = static_cast<std::uint8_t>(node % transfers_.size());
    if (data.size() != sdo_length) {
        return fmt::format("node {}: {}, no SDO: it has eight bytes", node, bytes_text(data));
    }
    if (data[0] == abort_command) {
        const std::string object = object_text(node, wire::load_u16(data.data() + 1), data[3]);
        transfers_[node].mode = Mode::none;
        return base::printable(fmt::format("node {} {} {}: {}", node, request ? "is told to stop" : "refuses",
                                           object, abort_message(data)));
    }
    const Mode mode = transfers_[node].mode;
    const bool block = mode == Mode::block_download || mode == Mode::block_upload;
    const std::string text = block     ? block_text(node, request, data)
                             : request ? request_text(node, data)
                                       : answer_text(node, data);
    return base::printable(fmt::format("node {} {}", node, text));
}

std::string SdoListener::request_text(std::uint8_t node, Bytes data) {
    const std::string object = object_text(node, wire::load_u16(data.data() + 1), data[3]);
    switch (data[0] >> 5) {
        case initiate_upload:
            begin(node, Mode::upload, data);
            return "read " + object + "?";
        case initiate_download:
            begin(node, Mode::download, data);
            if ((data[0] & expedited) == 0) {
                return "write " + object + ", in segments";
            }
            keep_expedited(transfers_[node], data);
            return fmt::format("write {} = {}", object, value_text(node, transfers_[node]));
        case upload_segment:
            return "next segment?";
        case download_segment:
            return segment_text(node, false, data);
        case block_upload:
            begin(node, Mode::block_upload, data);
            return "read " + object + "?, as a block";
        case block_download:
            begin(node, Mode::block_download, data);
            return "write " + object + ", as a block";
        default:
            return "unknown command: " + bytes_text(data);
    }
}

std::string SdoListener::answer_text(std::uint8_t node, Bytes data) {
    const std::string object = object_text(node, wire::load_u16(data.data() + 1), data[3]);
    switch (data[0] >> 5) {
        case upload_answer: {
            begin(node, Mode::upload, data);
            if ((data[0] & expedited) == 0) {
                return "answers " + object + ", in segments";
            }
            Transfer& transfer = transfers_[node];
            keep_expedited(transfer, data);
            transfer.mode = Mode::none;
            return fmt::format("answers {} = {}", object, value_text(node, transfer));
        }
        case download_answer:
            return "has written " + object;
        case download_segment_answer:
            return "has taken the segment";
        case upload_segment_answer:
            return segment_text(node, true, data);
        case block_download_answer:
        case block_upload_answer:
            return "answers to a block transfer: " + bytes_text(data);
        default:
            return "unknown answer: " + bytes_text(data);
    }
}

std::string SdoListener::segment_text(std::uint8_t node, bool upload, Bytes data) {
    Transfer& transfer = transfers_[node];
    if (transfer.mode != (upload ? Mode::upload : Mode::download)) {
        return "segment of a transfer that is not in the log: " + bytes_text(data.subspan(1));
    }
    const std::size_t count = segment_bytes - (data[0] >> 1 & 7U);
    for (std::size_t i = 0; i < count; ++i, ++transfer.count) {
        if (transfer.count < transfer.kept.size()) {
            transfer.kept[transfer.count] = data[1 + i];
        }
    }
    if ((data[0] & last_segment) == 0) {
        return fmt::format("segment, {} bytes so far", transfer.count);
    }
    transfer.mode = Mode::none;
    return fmt::format("{} {} = {}", upload ? "has answered" : "write",
                       object_text(node, transfer.index, transfer.sub_index), value_text(node, transfer));
}

std::string SdoListener::block_text(std::uint8_t node, bool request, Bytes data) {
    Transfer& transfer = transfers_[node];
    const bool upload = transfer.mode == Mode::block_upload;
    const std::string object = object_text(node, transfer.index, transfer.sub_index);
    if (upload == request && data[0] == block_end) {  // the receiving side has all
        transfer.mode = Mode::none;
        return fmt::format("block transfer of {} is complete", object);
    }
    return fmt::format("block transfer of {}: {}", object, bytes_text(data));
}

}  // namespace cgw::traffic
