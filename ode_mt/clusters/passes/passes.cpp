#include "clusters/passes/passes.h"

std::unique_ptr<dxCrossoverPass> dxMakeCrossoverPass(const std::string &name) {
    std::unique_ptr<dxCrossoverPass> passes[] = {dxMakeOriginalPass(), dxMakeStaticPass(), dxMakeStaticUnmergedPass(),
                                                 dxMakeDuplicationPass(), dxMakeDeclusterPass()};
    for (auto &pass : passes)
        if (pass->name() == name) return std::move(pass);
    return nullptr;
}
