package net.sf.jaer.eventprocessing;

import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeSupport;
import java.util.logging.Logger;
import net.sf.jaer.chip.AEChip;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public abstract class EventFilter {
    public static final Logger log = Logger.getAnonymousLogger();
    protected AEChip chip;

    public EventFilter(AEChip chip) {
        throw new UnsupportedOperationException();
    }

    public abstract void resetFilter();

    public abstract void initFilter();

    public synchronized void setFilterEnabled(boolean enabled) {
        throw new UnsupportedOperationException();
    }

    public boolean isFilterEnabled() {
        throw new UnsupportedOperationException();
    }

    public PropertyChangeSupport getSupport() {
        throw new UnsupportedOperationException();
    }

    protected void maybeAddListeners(AEChip chip) {
        throw new UnsupportedOperationException();
    }

    public void propertyChange(PropertyChangeEvent evt) {
        throw new UnsupportedOperationException();
    }

    public boolean isPreferenceStored(String key) {
        throw new UnsupportedOperationException();
    }

    public void putInt(String key, int value) {
        throw new UnsupportedOperationException();
    }

    public void putFloat(String key, float value) {
        throw new UnsupportedOperationException();
    }

    public void putBoolean(String key, boolean value) {
        throw new UnsupportedOperationException();
    }

    public void putString(String key, String value) {
        throw new UnsupportedOperationException();
    }

    public int getInt(String key, int def) {
        throw new UnsupportedOperationException();
    }

    public float getFloat(String key, float def) {
        throw new UnsupportedOperationException();
    }

    public boolean getBoolean(String key, boolean def) {
        throw new UnsupportedOperationException();
    }

    public String getString(String key, String def) {
        throw new UnsupportedOperationException();
    }

    protected void hideProperty(String propertyName) {
        throw new UnsupportedOperationException();
    }

    public final void setPropertyTooltip(String propertyName, String tooltip) {
        throw new UnsupportedOperationException();
    }

    public final void setPropertyTooltip(String groupName, String propertyName, String tooltip) {
        throw new UnsupportedOperationException();
    }
}
