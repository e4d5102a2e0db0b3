#include "runtime/keeper.hpp"

#include <fmt/format.h>

namespace cgw::runtime {

std::string_view interface_name(Side side) {
    return side == Side::can1 ? "can1" : "can2";
}

void Keeper::record(Side side, const frame::Frame& frame, std::uint64_t wall_time) {
    if (log_) {
        log_->record({wall_time, std::string(interface_name(side)), frame});
    }
}

void Keeper::write(const Sentinels& sentinels) {
    if (log_) {
        follow(log_->flush(), log_->path(), failed_log_);
    }
    if (memory_) {
        follow(memory_->keep(sentinels), memory_->path(), failed_memory_);
    }
}

void Keeper::follow(const base::Result<void>& result, std::string_view what, bool& failed) {
    if (!result && !failed) {
        complain_(fmt::format("{}; the gateway goes on, and tries again", result.error().message));
    } else if (result && failed) {
        complain_(fmt::format("{} can be written again", what));
    }
    failed = !result;
}

}  // namespace cgw::runtime
