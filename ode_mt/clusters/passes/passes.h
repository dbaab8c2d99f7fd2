// Makers of the passes, one file each.
#pragma once

#include <memory>

#include "clusters/dxCrossoverPass.h"

std::unique_ptr<dxCrossoverPass> dxMakeOriginalPass();
std::unique_ptr<dxCrossoverPass> dxMakeStaticPass();
std::unique_ptr<dxCrossoverPass> dxMakeStaticUnmergedPass();
std::unique_ptr<dxCrossoverPass> dxMakeDuplicationPass();
std::unique_ptr<dxCrossoverPass> dxMakeDeclusterPass();
