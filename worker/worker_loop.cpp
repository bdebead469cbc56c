#include "worker_loop.hpp"

#include <span>
#include <vector>

#include "clocks.hpp"
#include "io/series_file.hpp"
#include "message.hpp"

namespace hawser::worker {

io::RankTimes worker_loop(const io::Link& link, Lines& lines, io::SeriesWriter* results,
                          int platforms, bool between) {
    io::RankTimes times;
    bool running = false;  // a pass has been made
    double cpu = 0.0, idle = 0.0;
    std::vector<double> message;
    for (bool more = true; more;) {
        OrderMessage sent{};
        link.broadcast(std::span(sent).first(static_cast<std::size_t>(order_numbers(platforms))));
        const Order order = unpack(sent);
        const double start = wall_seconds();
        if (order.ask == Ask::run_to && !running) {
            running = true;
            cpu = user_cpu_seconds();
            idle = start;
        }
        if (order.sample) results->add_time(io::Clock::sample, order.t0);
        if (order.snapshot) results->add_time(io::Clock::snapshot, order.t0);
        lines.send(order);  // keeps and samples
        if (order.write_segment) results->write_segment();
        switch (order.ask) {
            case Ask::run_to:
            case Ask::equilibrium:
            case Ask::impedance: {
                const Reply& reply = lines.receive();
                const int n = static_cast<int>(reply.lines.size());
                message.resize(static_cast<std::size_t>(reply_numbers(order.ask, n, between)));
                pack_reply_to(reply, order.ask, message, between);
                break;
            }
            case Ask::stop:
                more = false;
                break;
        }
        if (running) {  // all of the time loop, and nothing after it, as rank 0 counts
            times.waited += start - idle;
            idle = more ? wall_seconds() : start;
            times.busy += idle - start;
        }
        if (more) link.gather(message, {}, {});
    }
    if (running) times.user_cpu = user_cpu_seconds() - cpu;
    return times;
}

}  // namespace hawser::worker
