#include "hgp/base/observed_work.h"

namespace hgp {
namespace {

WorkObserver*& observerHere() {
  thread_local WorkObserver* observer = nullptr;
  return observer;
}

}  // namespace

ObservedWork::ObservedWork(WorkObserver& observer) { observerHere() = &observer; }
ObservedWork::~ObservedWork() { observerHere() = nullptr; }
WorkObserver* ObservedWork::here() { return observerHere(); }

}  // namespace hgp
