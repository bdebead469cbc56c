#include "stop_signal.hpp"

#include <csignal>
#include <cstdlib>

#include "status.hpp"

namespace hawser {

namespace {

volatile std::sig_atomic_t noted = 0;  // a signal handler can reach nothing but a global

extern "C" void note_stop_signal(int signal) {
    const bool impatient =
        (signal == SIGINT || signal == SIGTERM) && (noted == SIGINT || noted == SIGTERM);
    if (impatient) std::_Exit(static_cast<int>(ExitCode::stopped));
    if (noted != SIGINT && noted != SIGTERM) noted = signal;
}

}  // namespace

void watch_stop_signals() {
    struct sigaction action {};
    action.sa_handler = note_stop_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaction(signal, &action, nullptr);
}

int stop_signal() { return noted; }

}  // namespace hawser
