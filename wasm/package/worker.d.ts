// The worker's script has no exports; give its URL to `createWorker` where a bundler or a
// Content-Security-Policy needs to know it: new Worker(url, { type: 'module' }).
export {};
