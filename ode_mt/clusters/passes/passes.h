// Makers of the passes, one file each (thesis chapters 2 and 5 to 8).
#pragma once

#include <memory>

#include "clusters/dxCrossoverPass.h"

std::unique_ptr<dxCrossoverPass> dxMakeOriginalPass();
std::unique_ptr<dxCrossoverPass> dxMakeStaticPass();
std::unique_ptr<dxCrossoverPass> dxMakeStaticUnmergedPass();
std::unique_ptr<dxCrossoverPass> dxMakeDuplicationPass();
std::unique_ptr<dxCrossoverPass> dxMakeDeclusterPass();
