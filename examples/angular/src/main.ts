import { provideZonelessChangeDetection } from '@angular/core';
import { bootstrapApplication } from '@angular/platform-browser';
import { configure } from 'x3d-physics';
import { App } from './app/app';

// Angular's build copies it there, see angular.json.
configure({ wasmUrl: 'assets/ammo.wasm' });

void bootstrapApplication(App, { providers: [provideZonelessChangeDetection()] });
