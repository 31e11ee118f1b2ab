// bites: conversion
namespace mayfly {
int truncate(double metres) { return metres; }
}  // namespace mayfly
