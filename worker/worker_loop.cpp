#include "worker_loop.hpp"

#include <chrono>
#include <vector>

#include "message.hpp"

namespace hawser::worker {

namespace {
double seconds() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}
}  // namespace

WorkerTimes worker_loop(const io::Link& link, Lines& lines, io::SeriesWriter*) {
    WorkerTimes times;
    std::vector<double> message;
    for (bool more = true; more;) {
        const double idle = seconds();
        OrderMessage sent{};
        link.broadcast(sent);
        const double start = seconds();
        const Order order = unpack(sent);
        lines.send(order);  // the flags first
        switch (order.ask) {
            case Ask::run_to:
            case Ask::equilibrium: {
                const Reply& reply = lines.receive();
                message.resize(static_cast<size_t>(
                    reply_numbers(order.ask, static_cast<int>(reply.lines.size()))));
                pack_reply_to(reply, order.ask, message);
                break;
            }
            case Ask::stop:
                more = false;
                break;
        }
        const double done = seconds();
        times.waited += start - idle;
        times.busy += done - start;
        if (more) link.gather(message, {}, {});
    }
    return times;
}

}  // namespace hawser::worker
