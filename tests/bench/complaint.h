// What a call complains about.
#pragma once

#include <stdexcept>
#include <string>

// Returns the text of the std::exception that `function` throws; empty: it throws none.
template <class Function>
std::string complaint(Function function) {
    try {
        function();
    } catch (const std::exception &error) {
        return error.what();
    }
    return "";
}
