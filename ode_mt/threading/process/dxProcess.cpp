#include "threading/process/dxProcess.h"

std::atomic<dxProcess::Member *> dxProcess::s_latest{nullptr};

void dxProcess::add(Member &member) {
    member.next = s_latest.load(std::memory_order_relaxed);
    s_latest.store(&member, std::memory_order_release);
}

void dxProcess::close() {
    for (const Member *member = s_latest.load(std::memory_order_acquire); member != nullptr; member = member->next)
        if (member->close != nullptr) member->close(member->object);
}

void dxProcess::unload() {
    for (const Member *member = s_latest.load(std::memory_order_acquire); member != nullptr; member = member->next)
        if (member->unload != nullptr) member->unload(member->object);
}
