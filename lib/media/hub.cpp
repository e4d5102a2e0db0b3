#include "media/hub.hpp"

#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

namespace cgw::media {
namespace {

constexpr int kernel_buffer = 64 * 1024;   // per client; what waits there is no longer counted
constexpr Time listening_pause = 200'000;  // when the system has no room for another connection
constexpr std::size_t longest_quotation = 24;

// What a client said, for an answer to it.
std::string quoted(std::string_view text) {
    const bool cut = text.size() > longest_quotation;
    return fmt::format("'{}{}'", text.substr(0, longest_quotation), cut ? "..." : "");
}

}  // namespace

struct Hub::Command {
    std::string_view word;
    bool needs_bus;
    void (Hub::*run)(HubClient& client, std::string_view words, Time now);
};

const Hub::Command Hub::commands[] = {
    {"open", false, &Hub::open},          {"rawmode", true, &Hub::raw_mode}, {"send", true, &Hub::send},
    {"sendrtr", true, &Hub::send_remote}, {"echo", false, &Hub::echo},
};

Hub::Hub(HubOptions options, std::function<std::uint64_t()> clock,
         std::function<void(std::string_view)> report)
    : options_(std::move(options)), clock_(std::move(clock)), report_(std::move(report)) {}

Hub::~Hub() = default;

base::Result<void> Hub::listen(const HostPort& where) {
    base::Result<Descriptor> socket = listen_on(where);
    if (!socket) {
        return tl::unexpected(socket.error());
    }
    listener_ = std::move(*socket);
    return {};
}

void Hub::join(Descriptor socket, std::string name, Time now) {
    if (clients_.size() >= options_.limits.clients) {
        ++counters_.refused;
        SendQueue farewell;
        farewell.add(error_message("the hub is full"), MessageStream::longest);
        farewell.flush(socket.get());
        report_(fmt::format("{} is refused: there are {} clients already", name, clients_.size()));
        return;
    }
    prepare_stream(socket.get(), kernel_buffer);
    clients_.push_back(std::make_unique<HubClient>(std::move(socket), std::move(name), options_.limits, now));
    clients_.back()->answer(message_of("hi"), now);
    clients_.back()->flush(now);
}

void Hub::watch(std::vector<pollfd>& entries) const {
    entries.push_back({listen_again_ == 0 ? listener_.get() : -1, POLLIN, 0});
    for (const auto& client : clients_) {
        entries.push_back(client->entry());
    }
}

Time Hub::deadline() const {
    Time first = listen_again_ == 0 ? never : listen_again_;
    for (const auto& client : clients_) {
        first = std::min(first, client->deadline());
    }
    return first;
}

void Hub::service(std::span<const pollfd> entries, Time now) {
    for (std::size_t i = 1; i < entries.size(); ++i) {
        HubClient& client = *clients_[i - 1];
        if ((entries[i].revents & ~POLLOUT) != 0) {
            client.receive(entries[i].revents, now);
        }
        if (entries[i].revents != 0 || client.stalled()) {
            client.flush(now);
            listen_to(client, now);
        }
    }
    for (const auto& client : clients_) {
        client->flush(now);
        client->check(now);
    }
    let_go();
    if (listen_again_ <= now) {
        listen_again_ = 0;
    }
    if (!entries.empty() && entries[0].revents != 0) {
        accept(now);
    }
}

void Hub::accept(Time now) {
    Address from;
    from.length = sizeof from.storage;
    Descriptor socket(::accept4(listener_.get(), reinterpret_cast<sockaddr*>(&from.storage), &from.length,
                                SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket) {
        join(std::move(socket), from.text(), now);
    } else if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
        listen_again_ = now + listening_pause;
    }
}

void Hub::listen_to(HubClient& client, Time now) {
    std::string_view text;
    for (;;) {
        switch (client.next(text)) {
            case MessageStream::Item::none:
                return;
            case MessageStream::Item::message:
                obey(client, text, now);
                break;
            case MessageStream::Item::junk:
                refuse(client, "text outside a message", now);
                break;
            case MessageStream::Item::too_long:
                refuse(client, "message too long", now);
                client.flush(now);
                client.leave("sends what is no message");
                return;
        }
    }
}

void Hub::obey(HubClient& client, std::string_view text, Time now) {
    const std::string_view whole = text;
    const std::string_view word = next_word(text);
    const auto* const command = std::find_if(std::begin(commands), std::end(commands),
                                             [&](const Command& row) { return row.word == word; });
    if (command == std::end(commands)) {
        refuse(client, fmt::format("unknown message {}", quoted(whole)), now);
    } else if (command->needs_bus && client.bus().empty()) {
        refuse(client, "open a bus first", now);
    } else {
        (this->*command->run)(client, text, now);
    }
}

void Hub::open(HubClient& client, std::string_view words, Time now) {
    const std::string_view name = next_word(words);
    const auto& known = options_.buses;
    if (!client.bus().empty()) {
        refuse(client, fmt::format("bus {} is open already", client.bus()), now);
    } else if (!is_bus_name(name) || !next_word(words).empty()) {
        refuse(client, "open one bus, whose name has 1..16 letters, digits, . _ or -", now);
    } else if (!known.empty() && std::find(known.begin(), known.end(), name) == known.end()) {
        refuse(client, fmt::format("no bus {}; there is {}", name, fmt::join(known, ", ")), now);
        client.flush(now);
        client.leave(fmt::format("wants bus {}, which is not there", name));
    } else {
        client.open(name);
        client.answer(message_of("ok"), now);
        report_(fmt::format("{} joins bus {}", client.name(), name));
    }
}

void Hub::raw_mode(HubClient& client, std::string_view, Time now) {
    client.enter_raw_mode(now);
}

void Hub::echo(HubClient& client, std::string_view, Time now) {
    client.answer(message_of("echo"), now);
}

void Hub::send(HubClient& client, std::string_view words, Time now) {
    distribute(client, parse_send(words), now);
}

void Hub::send_remote(HubClient& client, std::string_view words, Time now) {
    distribute(client, parse_sendrtr(words), now);
}

void Hub::distribute(HubClient& sender, const base::Result<frame::Frame>& frame, Time now) {
    if (!frame) {
        refuse(sender, frame.error().message, now);
        return;
    }
    ++counters_.frames;
    const std::string message = frame_message(*frame, clock_());
    for (const auto& client : clients_) {
        if (client.get() != &sender && client->takes_frames_of(sender.bus())) {
            const std::uint64_t before = client->lost();
            client->offer(message, now);
            counters_.lost += client->lost() - before;
        }
    }
}

void Hub::refuse(HubClient& client, std::string_view why, Time now) {
    ++counters_.refused;
    client.answer(error_message(why), now);
}

void Hub::let_go() {
    for (const auto& client : clients_) {
        if (client->gone()) {
            const std::string loss =
                client->lost() == 0 ? "" : fmt::format(", {} frames were lost for it", client->lost());
            report_(fmt::format("{} is gone: {}{}", client->name(), client->reason(), loss));
        }
    }
    std::erase_if(clients_, [](const auto& client) { return client->gone(); });
}

}  // namespace cgw::media
