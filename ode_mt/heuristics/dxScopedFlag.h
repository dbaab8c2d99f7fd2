// True as long as it lives, also when a callback throws: marks that a list is being walked.
#pragma once

class dxScopedFlag {
public:
    explicit dxScopedFlag(bool &flag) : m_flag(flag) { m_flag = true; }
    ~dxScopedFlag() { m_flag = false; }
    dxScopedFlag(const dxScopedFlag &) = delete;
    dxScopedFlag &operator=(const dxScopedFlag &) = delete;

private:
    bool &m_flag;
};
