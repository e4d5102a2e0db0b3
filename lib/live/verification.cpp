#include "live/verification.hpp"

#include <algorithm>

#include "canopen/nmt.hpp"

namespace cgw::live {

using canopen::SdoClient;
using object::AbortCode;
using Kind = Question::Kind;

namespace cob = canopen::cob;

Verification::Verification(std::vector<Question> plan, std::uint8_t node_id, frame::FramePort& port,
                           Pace pace)
    : plan_(std::move(plan)), node_id_(node_id), port_(&port), pace_(pace), client_(node_id, pace.timeout) {
    result_.values.resize(plan_.size());
    if (plan_.empty()) {
        end(Ending::complete);
    }
}

void Verification::receive(const frame::Frame& frame, Time now) {
    ++result_.heard.frames;
    const auto node = static_cast<std::uint8_t>(frame.id & cob::node_mask);
    if (!frame.extended && (frame.id & cob::function_mask) == cob::heartbeat && node != 0) {
        const auto state = canopen::heartbeat_state(frame);
        if (state && node == node_id_) {
            result_.heard.state = state;
        } else if (state) {
            result_.heard.others.set(node);
        }
    }
    if (!frame.extended && frame.id == cob::sdo_request + node_id_) {
        result_.heard.other_client = true;
    }
    if (!over()) {
        client_.receive(frame);
        conclude(now);
    }
}

Time Verification::poll(Time now) {
    if (over()) {
        return canopen::never;
    }
    if (!busy_ && now >= next_ask_) {
        ask(now);
    }
    Time deadline = client_.poll(now, *port_);
    conclude(now);
    if (over()) {
        return canopen::never;
    }
    // Also the word that a question is given up must leave before the next one.
    if (!client_.pending()) {
        unsendable_at_ = canopen::never;
    } else if (unsendable_at_ == canopen::never) {
        unsendable_at_ = now + pace_.unsendable;
    } else if (now >= unsendable_at_) {
        end(Ending::unsendable);
        return canopen::never;
    }
    if (!busy_) {
        deadline = std::min(deadline, next_ask_);
    }
    return std::min(deadline, unsendable_at_);
}

void Verification::ask(Time now) {
    if (client_.pending()) {
        next_ask_ = now + pace_.pause;
        return;
    }
    // What could not be read cannot be written back.
    while (result_.asked < plan_.size() && plan_[result_.asked].kind == Kind::not_writable &&
           !result_.values[plan_[result_.asked].read_by]) {
        ++result_.asked;
    }
    if (result_.asked == plan_.size()) {
        end(Ending::complete);
        return;
    }
    const Question& question = plan_[result_.asked];
    const canopen::sdo::Multiplexer object{question.index, question.sub_index};
    if (question.kind == Kind::not_writable) {
        client_.download(object, *result_.values[question.read_by], question.length);
    } else {
        client_.upload(object);
    }
    busy_ = true;
}

void Verification::conclude(Time now) {
    if (!busy_ || client_.status() == SdoClient::Status::busy) {
        return;
    }
    busy_ = false;
    next_ask_ = now + pace_.pause;
    const bool aborted = client_.status() == SdoClient::Status::aborted;
    const bool silent = aborted && client_.abort_code() == AbortCode::timed_out;
    // The client then tells the device so; a device that says it itself has answered.
    const bool garbled = aborted && client_.abort_code() == AbortCode::command_unknown && client_.pending();
    if ((silent || garbled) && ++attempt_ < pace_.attempts) {
        return;  // the same question again
    }
    attempt_ = 0;
    silences_ = silent ? silences_ + 1 : 0;
    result_.answers += silent ? 0U : 1U;
    if (silent) {
        differ(DifferenceKind::silent);
    } else if (garbled) {
        differ(DifferenceKind::garbled);
    } else {
        judge(plan_[result_.asked]);
    }
    const bool wrong = !result_.differences.empty() && result_.differences.back().question == result_.asked;
    const bool identified = !plan_[result_.asked].identifies || !wrong || silent;
    ++result_.asked;
    if (!identified) {
        end(Ending::other_device);
    } else if (silences_ >= pace_.silences) {
        result_.differences.resize(result_.differences.size() - silences_);
        end(Ending::silent);
    }
}

void Verification::judge(const Question& question) {
    switch (question.kind) {
        case Kind::value:
        case Kind::type:
            judge_read(question);
            break;
        case Kind::not_writable:
            expect_abort(AbortCode::read_only, DifferenceKind::writable);
            break;
        case Kind::no_sub_index:
            expect_abort(AbortCode::sub_index_missing, DifferenceKind::unexpected);
            break;
        case Kind::no_object:
            expect_abort(AbortCode::object_missing, DifferenceKind::unexpected);
            break;
    }
}

void Verification::judge_read(const Question& question) {
    if (client_.status() == SdoClient::Status::aborted) {
        const AbortCode code = client_.abort_code();
        const bool missing = code == AbortCode::object_missing || code == AbortCode::sub_index_missing;
        differ(missing ? DifferenceKind::missing : DifferenceKind::refused);
        return;
    }
    if (client_.length() != question.length) {
        differ(DifferenceKind::length);
        return;
    }
    result_.values[result_.asked] = client_.value();
    const std::uint32_t mask = 0xFFFF'FFFFU >> (8U * (4U - question.length));
    if (question.kind == Kind::value && client_.value() != (question.expected & mask)) {
        differ(DifferenceKind::value);
    }
}

void Verification::expect_abort(AbortCode expected, DifferenceKind accepted) {
    if (client_.status() == SdoClient::Status::done) {
        differ(accepted);
    } else if (client_.abort_code() != expected) {
        differ(DifferenceKind::refused);
    }
}

void Verification::differ(DifferenceKind kind) {
    Difference difference;
    difference.kind = kind;
    difference.question = result_.asked;
    if (client_.status() == SdoClient::Status::aborted) {
        difference.abort = client_.abort_code();
    } else if (plan_[result_.asked].kind != Kind::not_writable) {
        difference.value = client_.value();
        difference.length = client_.length();
    }
    result_.differences.push_back(difference);
}

void Verification::end(Ending ending) {
    if (!over()) {
        result_.ending = ending;
    }
}

}  // namespace cgw::live
